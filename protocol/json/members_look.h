// How a scene is shaded and lit, on the wire.
#pragma once

#include "protocol/commands/look.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

template <class V>
void members(V& v, Visited<V, FibreOptics>& c) {
  v.type("Fibre", "Fibres as the models energy_conserving, marschner and scheuermann take them.");
  v.number("longitudinal_roughness", c.longitudinal_roughness, share, "beta_m; energy_conserving.");
  v.number("azimuthal_roughness", c.azimuthal_roughness, share, "beta_n; energy_conserving.");
  v.number("cuticle_tilt", c.cuticle_tilt, {-15, 15}, "Degrees; turns reflected light to the root.");
  v.number("refractive_index", c.refractive_index, {1, 3});
  v.name("absorption", c.absorption, json_names::absorptions, "What the absorption is worked out from.");
  v.number("eumelanin", c.eumelanin, {0, 10000}, "Brown and black.");
  v.number("pheomelanin", c.pheomelanin, {0, 10000}, "Red.");
  v.number("highlight_width", c.highlight_width, {0, 90}, "Degrees; marschner.");
  v.number("caustic_width", c.caustic_width, {1, 60}, "Degrees; marschner.");
  v.number("primary_shift", c.primary_shift, {-2, 2}, "Above 0: highlight nearer the tip; scheuermann.");
  v.number("secondary_shift", c.secondary_shift, {-2, 2}, "scheuermann.");
  v.number("shift_spread", c.shift_spread, {0, 2}, "From strand to strand; scheuermann.");
  v.number("secondary_specular", c.secondary_specular, {0, 4}, "Of the coloured lobe; scheuermann.");
  v.number("secondary_exponent", c.secondary_exponent, {0, 1000000}, "scheuermann.");
}

template <class V>
void members(V& v, Visited<V, Look>& c) {
  v.type("Look", "How fur is shaded. What is not given takes its default.");
  v.name("shading", c.shading, json_names::shading_models, "How fibres scatter light.");
  v.object("fibre", c.fibre);
  v.name("colour_source", c.colour_source, json_names::colour_sources,
         "model: its texture or vertex colours; coat: the ramp; automatic: the model's where it has colours.");
  v.number("ambient", c.ambient, {0, 4});
  v.number("diffuse", c.diffuse, {0, 4});
  v.number("specular", c.specular, {0, 4});
  v.number("diffuse_exponent", c.diffuse_exponent, {0, 1000000});
  v.number("specular_exponent", c.specular_exponent, {0, 1000000});
  v.number("back_attenuation", c.back_attenuation, {0.001, 1});
  v.number("ambient_floor", c.ambient_floor, share, "Ambient light that reaches the roots.");
  v.number("self_shadow", c.self_shadow, {0, 4}, "Scales the optical depth to the light.");
  v.colour("skin", c.skin, "Colour under the fur where the model has none.");
}

template <class V>
void members(V& v, Visited<V, Light>& c) {
  v.type("Light");
  v.name("kind", c.kind, json_names::light_kinds,
         "area: a rectangle that shines along `direction` by the cosine, as bright from afar as a point light. Shells "
         "see it from its middle.");
  v.direction("direction", c.direction, "Where a directional, spot or area light goes.");
  v.position("position", c.position, "Of a point, spot or area light.");
  v.colour("colour", c.colour);
  v.number("intensity", c.intensity, {0, 100000000},
           "1 gives white; a point light's is measured at a distance of one size.");
  v.number("cone_degrees", c.cone_degrees, {0.1, 90}, "Half angle of a spot light.");
  v.number("cone_softness", c.cone_softness, share, "Share of the cone over which a spot light fades.");
  v.number("angle_degrees", c.angle_degrees, {0, 90},
           "Half angle that a directional light spans, for traced strands and a `penumbra`.");
  v.number("radius", c.radius, {0, 10},
           "Of the ball that a point or spot light is, sizes, for traced strands and a `penumbra`.");
  v.number("width", c.width, {0.001, 100}, "Of an area light, sizes; level.");
  v.number("height", c.height, {0.001, 100}, "Of an area light, sizes.");
  v.boolean("self_shadow_maps", c.self_shadow_maps,
            "Shadow maps of the shells in place of the estimate, in frames with `shadow_maps`.");
  v.name("cast_shadow", c.cast_shadow, json_names::cast_shadows,
         "Shadow of one part of the body on another, in frames with `shadow_maps`: with a sharp edge, with one that "
         "`shadow_scale` widens, or blurred by the light's size, nearest to traced strands.");
  v.number("shadow_scale", c.shadow_scale, {0, 1000}, "Larger makes the edge of a `soft` cast shadow narrower.");
}

template <class V>
void turn_member(V& v, Visited<V, Environment>& c) {
  v.number("turn_degrees", c.turn_degrees, {-360, 360}, "About +y, counter-clockwise seen from above; of harmonics.");
}

template <class V>
void intensity_member(V& v, Visited<V, Environment>& c) {
  v.number("intensity", c.intensity, {0, 100}, "Factor on its light.");
}

template <class V>
void members(V& v, Visited<V, Environment>& c) {
  v.type(
      "Environment",
      "Light from all around: a gradient, or spherical harmonics. It scales the look's `ambient`; white everywhere is "
      "constant light.");
  if (v.shows(!c.harmonics)) {
    v.colour("sky", c.sky, "From straight above.");
    v.colour("horizon", c.horizon);
    v.colour("ground", c.ground, "From straight below.");
  }
  v.vectors("harmonics", c.harmonics, {-limits::harmonic, limits::harmonic}, "In place of the three colours.");
  if (v.shows(c.harmonics.has_value())) turn_member(v, c);
  intensity_member(v, c);
}

template <class V>
void members(V& v, Visited<V, Ground>& c) {
  v.type("Ground", "A level ground that catches shadow. It darkens the background and shows nothing else.");
  v.boolean("visible", c.visible);
  v.number("height", c.height, coordinate, "The model's y; its lowest point when absent.");
  v.number("shadow", c.shadow, share, "How dark cast shadows get on it, in frames with `shadow_maps`.");
  v.number("contact", c.contact, share, "How dark it gets under the model.");
}

}  // namespace pelage::json_parts
