#include "protocol/json/encode_parts.h"

#include "protocol/json/colour.h"
#include "protocol/json/names.h"

namespace pelage::json_parts {

using json_names::text_of;

Json list(glm::dvec2 v) { return Json::array({v.x, v.y}); }
Json list(glm::dvec3 v) { return Json::array({v.x, v.y, v.z}); }

Json list(const std::vector<FrameLayer>& layers) {
  Json names = Json::array();
  for (const FrameLayer layer : layers) names.push_back(text_of(json_names::frame_layers, layer));
  return names;
}

Json colour(glm::vec3 linear) {
  if (const auto text = text_of_colour(linear)) return *text;
  return list(glm::dvec3(linear));
}

Json json_of(const Camera& camera) {
  if (camera.automatic != AutoView::none) return {{"auto", text_of(json_names::auto_views, camera.automatic)}};
  return {{"eye", list(camera.eye)},
          {"target", list(camera.target)},
          {"up", list(camera.up)},
          {"fov_degrees", camera.fov_degrees}};
}

Json json_of(const View& view) {
  return {{"camera", json_of(view.camera)}, {"width", view.width}, {"height", view.height}};
}

static Json json_of(const StrokeSample& sample) {
  Json json = Json::object();
  if (const auto* point = std::get_if<PositionPlace>(&sample.place)) {
    json["position"] = list(point->position);
  } else if (const auto* pixel = std::get_if<ScreenPlace>(&sample.place)) {
    json["screen"] = list(pixel->screen);
  } else {
    const auto& place = std::get<SurfacePlace>(sample.place);
    json["triangle"] = place.triangle;
    json["barycentric"] = list(place.barycentric);
  }
  json["pressure"] = sample.pressure;
  json["time"] = sample.time;
  return json;
}

Json json_of(const Stroke& stroke) {
  Json json = {{"id", stroke.id}, {"part", stroke.part}, {"last", stroke.last}};
  if (stroke.view) json["view"] = json_of(*stroke.view);
  json["samples"] = Json::array();
  for (const StrokeSample& sample : stroke.samples) json["samples"].push_back(json_of(sample));
  return json;
}

Json json_of(const Brush& brush) {
  Json json = {{"radius", brush.radius},
               {"units", text_of(json_names::radius_units, brush.units)},
               {"falloff_shape", text_of(json_names::falloff_shapes, brush.falloff_shape)},
               {"falloff", text_of(json_names::falloffs, brush.falloff)},
               {"strength", brush.strength},
               {"spacing", brush.spacing},
               {"pressure_to_radius", brush.pressure_to_radius},
               {"pressure_to_strength", brush.pressure_to_strength},
               {"front_faces_only", brush.front_faces_only},
               {"cut_off_degrees", brush.cut_off_degrees},
               {"invert", brush.invert},
               {"strand_from", brush.strand_from},
               {"strand_to", brush.strand_to}};
  if (!brush.falloff_points.empty()) json["falloff_points"] = brush.falloff_points;
  return json;
}

static Json json_of(const Undercoat& undercoat) {
  return {{"share", undercoat.share},
          {"length", undercoat.length},
          {"width", undercoat.width},
          {"lightness", undercoat.lightness},
          {"tint", undercoat.tint},
          {"colour", colour(undercoat.colour)}};
}

static Json json_of(const Tufts& tufts) {
  return {{"gather", tufts.gather}, {"size", tufts.size}, {"scales", tufts.scales}, {"seed", tufts.seed}};
}

static Json json_of(const OddHairs& odd) { return {{"share", odd.share}, {"colour", colour(odd.colour)}}; }

static Json json_of(const Pattern& pattern) {
  return {{"kind", text_of(json_names::pattern_kinds, pattern.kind)},
          {"scale", pattern.scale},
          {"coverage", pattern.coverage},
          {"contrast", pattern.contrast},
          {"softness", pattern.softness},
          {"warp", pattern.warp},
          {"legs", pattern.legs},
          {"inner", pattern.inner},
          {"belly", pattern.belly},
          {"axis", list(pattern.axis)},
          {"colour", colour(pattern.colour)},
          {"inner_colour", colour(pattern.inner_colour)},
          {"belly_colour", colour(pattern.belly_colour)},
          {"seed", pattern.seed}};
}

static Json json_of(const Variation& variation) {
  return {{"lightness", variation.lightness},
          {"hue", variation.hue},
          {"length", variation.length},
          {"lean", variation.lean},
          {"size", variation.size}};
}

Json json_of(const Coat& coat) {
  Json ramp = Json::array();
  for (const RampStop& stop : coat.ramp) ramp.push_back({{"at", stop.at}, {"colour", colour(stop.colour)}});
  return {{"count", coat.count},
          {"tile", coat.tile},
          {"width_root", coat.width_root},
          {"width_tip", coat.width_tip},
          {"bend", coat.bend},
          {"curl", coat.curl},
          {"curl_turns", coat.curl_turns},
          {"curl_together", coat.curl_together},
          {"wave", coat.wave},
          {"wave_turns", coat.wave_turns},
          {"mess", coat.mess},
          {"clump", coat.clump},
          {"clump_size", coat.clump_size},
          {"fine_clump", coat.fine_clump},
          {"fine_clump_size", coat.fine_clump_size},
          {"lodge", coat.lodge},
          {"lodge_size", coat.lodge_size},
          {"wetness", coat.wetness},
          {"length_spread", coat.length_spread},
          {"colour_spread", coat.colour_spread},
          {"root_share", coat.root_share},
          {"lean_curve", text_of(json_names::lean_curves, coat.lean_curve)},
          {"ramp", ramp},
          {"undercoat", json_of(coat.undercoat)},
          {"odd_hairs", json_of(coat.odd_hairs)},
          {"tufts", json_of(coat.tufts)},
          {"pattern", json_of(coat.pattern)},
          {"variation", json_of(coat.variation)},
          {"seed", coat.seed}};
}

static Json json_of(const FibreOptics& fibre) {
  return {{"longitudinal_roughness", fibre.longitudinal_roughness},
          {"azimuthal_roughness", fibre.azimuthal_roughness},
          {"cuticle_tilt", fibre.cuticle_tilt},
          {"refractive_index", fibre.refractive_index},
          {"absorption", text_of(json_names::absorptions, fibre.absorption)},
          {"eumelanin", fibre.eumelanin},
          {"pheomelanin", fibre.pheomelanin},
          {"highlight_width", fibre.highlight_width},
          {"caustic_width", fibre.caustic_width},
          {"primary_shift", fibre.primary_shift},
          {"secondary_shift", fibre.secondary_shift},
          {"shift_spread", fibre.shift_spread},
          {"secondary_specular", fibre.secondary_specular},
          {"secondary_exponent", fibre.secondary_exponent}};
}

Json json_of(const Look& look) {
  return {{"colour_source", text_of(json_names::colour_sources, look.colour_source)},
          {"shading", text_of(json_names::shading_models, look.shading)},
          {"fibre", json_of(look.fibre)},
          {"ambient", look.ambient},
          {"diffuse", look.diffuse},
          {"specular", look.specular},
          {"diffuse_exponent", look.diffuse_exponent},
          {"specular_exponent", look.specular_exponent},
          {"back_attenuation", look.back_attenuation},
          {"ambient_floor", look.ambient_floor},
          {"self_shadow", look.self_shadow},
          {"skin", colour(look.skin)}};
}

static Json json_of(const Iris& iris) {
  return {{"colour", colour(iris.colour)},
          {"inner_colour", colour(iris.inner_colour)},
          {"size", iris.size},
          {"depth", iris.depth},
          {"relief", iris.relief},
          {"limbal_ring", iris.limbal_ring},
          {"turn_degrees", iris.turn_degrees}};
}

static Json json_of(const Pupil& pupil) {
  Json json = {{"shape", text_of(json_names::pupil_shapes, pupil.shape)}, {"size", "automatic"}};
  if (pupil.size) json["size"] = *pupil.size;
  return json;
}

static Json json_of(const Lids& lids) {
  Json json = {{"width_degrees", lids.width_degrees},
               {"upper_degrees", lids.upper_degrees},
               {"lower_degrees", lids.lower_degrees},
               {"tilt_degrees", lids.tilt_degrees},
               {"colour", colour(lids.colour)}};
  if (lids.facing) json["facing"] = list(*lids.facing);
  return json;
}

Json json_of(const Eye& eye) {
  Json json = {{"position", list(eye.position)}, {"radius", eye.radius}};
  json[eye.look_at ? "look_at" : "gaze"] = list(eye.look_at.value_or(eye.gaze));
  json["iris"] = json_of(eye.iris);
  json["pupil"] = json_of(eye.pupil);
  if (eye.lids) json["lids"] = json_of(*eye.lids);
  json["sclera"] = colour(eye.sclera);
  json["bulge"] = eye.bulge;
  json["refraction"] = eye.refraction;
  json["wetness"] = eye.wetness;
  return json;
}

Json json_of(const CurveGroup& group) {
  Json curves = Json::array();
  for (const GuideCurve& curve : group.curves) {
    Json& points = curves.emplace_back(Json::array());
    for (const glm::dvec3& point : curve) points.push_back(list(point));
  }
  return {{"curves", std::move(curves)},
          {"width_root", group.width_root},
          {"width_tip", group.width_tip},
          {"root_colour", colour(group.root_colour)},
          {"tip_colour", colour(group.tip_colour)},
          {"fill", group.fill},
          {"spread", group.spread},
          {"seed", group.seed}};
}

static Json json_of(const SkinFacing& facing) {
  return {{"direction", list(facing.direction)},
          {"angle_degrees", facing.angle_degrees},
          {"fade_degrees", facing.fade_degrees}};
}

Json json_of(const SkinRegion& region) {
  Json json = {{"centre", list(region.centre)},
               {"radii", list(region.radii)},
               {"axis", list(region.axis)},
               {"turn_degrees", region.turn_degrees},
               {"softness", region.softness},
               {"colour", colour(region.colour)},
               {"shine", region.shine},
               {"roughness", region.roughness},
               {"wetness", region.wetness},
               {"scatter", region.scatter},
               {"bumps", {{"height", region.bumps.height}, {"size", region.bumps.size}}}};
  if (region.facing) json["facing"] = json_of(*region.facing);
  return json;
}

Json json_of(const Light& light) {
  return {{"kind", text_of(json_names::light_kinds, light.kind)},
          {"direction", list(light.direction)},
          {"position", list(light.position)},
          {"colour", colour(light.colour)},
          {"intensity", light.intensity},
          {"cone_degrees", light.cone_degrees},
          {"cone_softness", light.cone_softness},
          {"angle_degrees", light.angle_degrees},
          {"radius", light.radius},
          {"width", light.width},
          {"height", light.height},
          {"self_shadow_maps", light.self_shadow_maps},
          {"cast_shadow", text_of(json_names::cast_shadows, light.cast_shadow)},
          {"shadow_scale", light.shadow_scale}};
}

Json json_of(const Environment& environment) {
  if (environment.harmonics) {
    Json harmonics = Json::array();
    for (const glm::dvec3& coefficient : *environment.harmonics) harmonics.push_back(list(coefficient));
    return {{"harmonics", harmonics}, {"turn_degrees", environment.turn_degrees}, {"intensity", environment.intensity}};
  }
  return {{"sky", colour(environment.sky)},
          {"horizon", colour(environment.horizon)},
          {"ground", colour(environment.ground)},
          {"intensity", environment.intensity}};
}

Json json_of(const Ground& ground) {
  Json json = {{"visible", ground.visible}, {"shadow", ground.shadow}, {"contact", ground.contact}};
  if (ground.height) json["height"] = *ground.height;
  return json;
}

}  // namespace pelage::json_parts
