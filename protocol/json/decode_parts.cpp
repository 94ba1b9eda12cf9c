#include "protocol/json/decode_parts.h"

#include <cmath>

namespace pelage::json_parts {

namespace {

constexpr Range screen_coordinate{-1e6, 1e6};

StrokeSample sample(const Value& value) {
  Object object(value);
  StrokeSample result;
  int places = 0;
  object.optional("position", [&](const Value& v) {
    result.place = PositionPlace{v.triple(coordinate)};
    ++places;
  });
  object.optional("screen", [&](const Value& v) {
    result.place = ScreenPlace{v.pair(screen_coordinate)};
    ++places;
  });
  const bool on_triangle = object.has("triangle");
  const bool has_barycentric = object.has("barycentric");
  if (on_triangle || has_barycentric) {
    SurfacePlace place;
    object.required("triangle", [&](const Value& v) {
      place.triangle = static_cast<std::uint32_t>(v.integer({0, 4294967295.0}));
    });
    object.required("barycentric", [&](const Value& v) {
      place.barycentric = v.triple(share);
      const double sum = place.barycentric.x + place.barycentric.y + place.barycentric.z;
      if (std::abs(sum - 1) > 1e-3) v.refuse("The barycentrics do not add up to 1.", "sum within 0.001 of 1");
    });
    result.place = place;
    ++places;
  }
  object.number("pressure", result.pressure, share);
  object.number("time", result.time, {0, 1e6});
  object.finish();
  if (places != 1) value.refuse("A sample needs one place.", "one of position | screen | triangle with barycentric");
  return result;
}

void check_stroke(const Value& value, const Stroke& stroke) {
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    const StrokeSample& sample = stroke.samples[i];
    const std::string name = "samples/" + std::to_string(i);
    if (i > 0 && sample.time < stroke.samples[i - 1].time) {
      value.refuse_below(name + "/time", "Time falls from one sample to the next.", "not falling");
    }
    if (!stroke.view && std::holds_alternative<ScreenPlace>(sample.place)) {
      value.refuse_below("view", "Pixel samples need the view that they were drawn on.", "required");
    }
  }
}

}  // namespace

Camera camera(const Value& value) {
  Object object(value);
  Camera result;
  if (object.has("auto")) {
    object.name("auto", result.automatic, json_names::auto_views);
    object.finish();
    return result;
  }
  result.automatic = AutoView::none;
  object.required("eye", [&](const Value& v) { result.eye = v.triple(coordinate); });
  object.required("target", [&](const Value& v) { result.target = v.triple(coordinate); });
  object.optional("up", [&](const Value& v) { result.up = v.direction(); });
  object.number("fov_degrees", result.fov_degrees, {1, 150});
  object.finish();
  const glm::dvec3 forward = result.target - result.eye;
  if (!(glm::length(forward) > 0)) {
    value.refuse("The eye is at the target.", "eye differs from target");
  } else if (glm::length(glm::cross(glm::normalize(forward), glm::normalize(result.up))) < 1e-6) {
    value.refuse_below("up", "Up points along the view.", "not along the view");
  }
  return result;
}

View view(const Value& value) {
  Object object(value);
  View result;
  object.optional("camera", [&](const Value& v) { result.camera = camera(v); });
  object.integer("width", result.width, pixels);
  object.integer("height", result.height, pixels);
  object.finish();
  return result;
}

FibreOptics fibre(const Value& value) {
  Object object(value);
  FibreOptics result;
  object.number("longitudinal_roughness", result.longitudinal_roughness, share);
  object.number("azimuthal_roughness", result.azimuthal_roughness, share);
  object.number("cuticle_tilt", result.cuticle_tilt, {-15, 15});
  object.number("refractive_index", result.refractive_index, {1, 3});
  object.name("absorption", result.absorption, json_names::absorptions);
  object.number("eumelanin", result.eumelanin, {0, 1e4});
  object.number("pheomelanin", result.pheomelanin, {0, 1e4});
  object.number("highlight_width", result.highlight_width, {0, 90});
  object.number("caustic_width", result.caustic_width, {1, 60});
  object.number("primary_shift", result.primary_shift, {-2, 2});
  object.number("secondary_shift", result.secondary_shift, {-2, 2});
  object.number("shift_spread", result.shift_spread, {0, 2});
  object.number("secondary_specular", result.secondary_specular, {0, 4});
  object.number("secondary_exponent", result.secondary_exponent, {0, 1e6});
  object.finish();
  return result;
}

Look look(const Value& value) {
  Object object(value);
  Look result;
  object.name("shading", result.shading, json_names::shading_models);
  object.optional("fibre", [&](const Value& v) { result.fibre = fibre(v); });
  object.name("colour_source", result.colour_source, json_names::colour_sources);
  object.number("ambient", result.ambient, {0, 4});
  object.number("diffuse", result.diffuse, {0, 4});
  object.number("specular", result.specular, {0, 4});
  object.number("diffuse_exponent", result.diffuse_exponent, {0, 1e6});
  object.number("specular_exponent", result.specular_exponent, {0, 1e6});
  object.number("back_attenuation", result.back_attenuation, {1e-3, 1});
  object.number("ambient_floor", result.ambient_floor, share);
  object.number("self_shadow", result.self_shadow, {0, 4});
  object.colour("skin", result.skin);
  object.finish();
  return result;
}

Light light(const Value& value) {
  Object object(value);
  Light result;
  object.name("kind", result.kind, json_names::light_kinds);
  object.optional("direction", [&](const Value& v) { result.direction = v.direction(); });
  object.triple("position", result.position, coordinate);
  object.colour("colour", result.colour);
  object.number("intensity", result.intensity, {0, 1e8});
  object.number("cone_degrees", result.cone_degrees, {0.1, 90});
  object.number("cone_softness", result.cone_softness, share);
  object.number("angle_degrees", result.angle_degrees, {0, 90});
  object.number("radius", result.radius, {0, 10});
  object.number("width", result.width, {1e-3, 100});
  object.number("height", result.height, {1e-3, 100});
  object.boolean("self_shadow_maps", result.self_shadow_maps);
  object.name("cast_shadow", result.cast_shadow, json_names::cast_shadows);
  object.number("shadow_scale", result.shadow_scale, {0, 1000});
  object.finish();
  return result;
}

SphericalHarmonics harmonics(const Value& value) {
  SphericalHarmonics result{};
  const std::vector<Value> members = value.list(result.size(), result.size());
  for (std::size_t i = 0; i < members.size(); ++i) result[i] = members[i].triple({-limits::harmonic, limits::harmonic});
  return result;
}

Environment environment(const Value& value) {
  Object object(value);
  Environment result;
  object.colour("sky", result.sky);
  object.colour("horizon", result.horizon);
  object.colour("ground", result.ground);
  object.optional("harmonics", [&](const Value& v) { result.harmonics = harmonics(v); });
  object.number("turn_degrees", result.turn_degrees, {-360, 360});
  object.number("intensity", result.intensity, {0, 100});
  object.finish();
  const bool gradient = object.has("sky") || object.has("horizon") || object.has("ground");
  if (result.harmonics && gradient) {
    value.refuse_below("harmonics", "Harmonics and the colours of a gradient exclude each other.",
                       "harmonics, or sky, horizon and ground");
  } else if (!result.harmonics && object.has("turn_degrees")) {
    value.refuse_below("turn_degrees", "A gradient is the same however it is turned.", "with harmonics only");
  }
  return result;
}

Ground ground(const Value& value) {
  Object object(value);
  Ground result;
  object.boolean("visible", result.visible);
  object.optional("height", [&](const Value& v) { result.height = v.number(coordinate); });
  object.number("shadow", result.shadow, share);
  object.number("contact", result.contact, share);
  object.finish();
  return result;
}

Brush brush(const Value& value) {
  Object object(value);
  Brush result;
  object.number("radius", result.radius, length_in_units);
  object.name("units", result.units, json_names::radius_units);
  object.name("falloff_shape", result.falloff_shape, json_names::falloff_shapes);
  object.name("falloff", result.falloff, json_names::falloffs);
  object.number("strength", result.strength, share);
  object.number("spacing", result.spacing, {0.01, 10});
  object.optional("falloff_points", [&](const Value& list) {
    for (const Value& point : list.list(2, limits::falloff_points)) result.falloff_points.push_back(point.number(share));
  });
  object.number("pressure_to_radius", result.pressure_to_radius, share);
  object.number("pressure_to_strength", result.pressure_to_strength, share);
  object.number("cut_off_degrees", result.cut_off_degrees, half_circle);
  object.boolean("front_faces_only", result.front_faces_only);
  object.boolean("invert", result.invert);
  object.number("strand_from", result.strand_from, share);
  object.number("strand_to", result.strand_to, share);
  object.finish();
  return result;
}

Stroke stroke(const Value& value) {
  Object object(value);
  Stroke result;
  object.optional("id", [&](const Value& v) { result.id = v.text(0, limits::name_bytes); });
  object.integer("part", result.part);
  object.boolean("last", result.last);
  object.optional("view", [&](const Value& v) { result.view = view(v); });
  object.required("samples", [&](const Value& list) {
    for (const Value& member : list.list(1, limits::samples_per_stroke)) result.samples.push_back(sample(member));
  });
  object.finish();
  check_stroke(value, result);
  return result;
}

FirstGroom fur(const Value& value) {
  Object object(value);
  FirstGroom result;
  object.number("length", result.length, {0, 10});
  object.number("inclination", result.inclination, share);
  object.name("form", result.form, json_names::groom_forms);
  object.finish();
  return result;
}

Tracing tracing(const Value& value) {
  Object object(value);
  Tracing result;
  object.integer("passes", result.passes, {1, limits::trace_passes});
  object.name("transport", result.transport, json_names::transports);
  object.name("scattering", result.scattering, json_names::strand_scatterings);
  object.integer("bounces", result.bounces, {1, 4096});
  object.integer("strands", result.strands, {1, limits::strands});
  object.number("noise", result.noise, share);
  object.number("seconds", result.seconds, {0, 3600});
  object.boolean("filter", result.filter);
  object.integer("seed", result.seed);
  object.finish();
  const bool paths = result.transport == Transport::paths;
  if (paths && object.has("scattering") && result.scattering == StrandScattering::look) {
    value.refuse_below("scattering", "Paths need a model that makes no light.", "energy_conserving");
  }
  if (paths) result.scattering = StrandScattering::energy_conserving;
  if (!paths && object.has("bounces")) value.refuse_below("bounces", "Only paths bounce.", "transport paths");
  return result;
}

/// Of shells alone, or of strands alone.
void check_method(const Value& value, Object& object, const Knobs& knobs) {
  const bool strands = knobs.method == Method::strands;
  for (const char* name : {"shells", "shell_policy", "samples", "steps", "scale", "least_radius", "bands", "self_shadow",
                           "shadow_maps", "shadow_resolution", "accumulation", "order", "fins"}) {
    if (strands && object.has(name)) value.refuse_below(name, "Traced strands have no shells.", "method shells");
  }
  if (!strands && object.has("trace")) value.refuse_below("trace", "Only strands are traced.", "method strands");
}

Knobs quality(const Value& value) {
  if (!value.tree().is_object()) return knobs_of(value.name_of(json_names::tiers));
  Object object(value);
  Knobs result = knobs_of(Tier::interactive);
  object.integer("shells", result.shells, {1, limits::shells});
  object.name("shell_policy", result.shell_policy, json_names::shell_policies);
  object.optional("samples", [&](const Value& v) {
    result.samples = static_cast<int>(v.integer({1, 4}));
    if (result.samples == 2 || result.samples == 3) v.refuse("Outlines take 1 or 4 samples.", "1 | 4");
  });
  object.integer("steps", result.steps, {1, 16});
  object.number("scale", result.scale, {0.25, 2});
  object.integer("least_radius", result.least_radius, {0, 8192});
  object.integer("bands", result.bands, {1, 4});
  object.integer("eye_steps", result.eye_steps, {0, 64});
  object.boolean("self_shadow", result.self_shadow);
  object.boolean("shadow_maps", result.shadow_maps);
  object.integer("shadow_resolution", result.shadow_resolution, {1, 4096});
  object.name("accumulation", result.accumulation, json_names::accumulations);
  object.name("order", result.order, json_names::fragment_orders);
  object.boolean("fins", result.fins);
  object.integer("guard_hairs", result.guard_hairs, {0, 100'000});
  object.name("method", result.method, json_names::methods);
  object.optional("trace", [&](const Value& v) { result.trace = tracing(v); });
  object.finish();
  check_method(value, object, result);
  if (result.order == FragmentOrder::sorted && result.samples != 1) {
    value.refuse_below("order", "Sorted fragments take one sample.", "samples 1; scale 2 for finer outlines");
  }
  return result;
}

}  // namespace pelage::json_parts
