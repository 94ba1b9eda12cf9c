#include "tests/extremes/any_scene.h"

#include <rapidcheck.h>

namespace pelage::testing {

namespace {

using Texts = std::vector<std::string>;

std::string any_of(Texts texts) { return *rc::gen::elementOf(std::move(texts)); }

bool chance(int percent) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 100)) < percent; }

/// A member of a JSON object, and the values to choose from.
struct Member {
  const char* name;
  Texts values;
};

/// A JSON object with a random subset of the members, each with a chance of `percent`.
std::string any_object(const std::vector<Member>& members, int percent = 40) {
  std::string text;
  for (const Member& member : members) {
    if (!chance(percent)) continue;
    text += (text.empty() ? "\"" : ", \"") + std::string(member.name) + "\": " + any_of(member.values);
  }
  return "{" + text + "}";
}

const Texts share{"0", "0.3", "1"}, truth{"true", "false"}, exponents{"0", "1", "40", "1e6"},
    colours{"\"#000000\"", "\"#ffffff\"", "[1, 0, 0]", "[0.2, 0.3, 0.1]"}, seeds{"0", "1", "4294967295"},
    positions{"[0, 0, 0]", "[0, 0, 1]", "[0, 0.4, 1.02]", "[0.7, 0.7, 0.7]", "[0, 1e6, 0]", "[-3, 2, 4]"},
    directions{"[0, 0, -1]", "[0, -1, 0]", "[1, -1, -1]", "[0, 0, 1]"};

std::string any_coat() {
  const Texts sizes{"0.001", "0.01", "0.5"};
  const std::string tufts = any_object({{"gather", share}, {"size", {"0.01", "0.1", "1"}}, {"scales", {"1", "3"}}});
  const std::string pattern = any_object(
      {{"kind",
        {"\"none\"", "\"stripes\"", "\"spots\"", "\"rosettes\"", "\"tabby\"", "\"patches\"", "\"countershading\""}},
       {"scale", {"0.005", "0.1", "2"}},
       {"coverage", share},
       {"softness", share},
       {"warp", {"0", "2"}},
       {"colour", colours},
       {"seed", seeds}});
  const std::string variation = any_object({{"lightness", share}, {"hue", share}, {"length", share}, {"lean", share}});
  const std::string under = any_object({{"share", share}, {"length", {"0.02", "1"}}, {"width", {"0.05", "4"}}});
  return any_object({{"count", {"1", "30", "2000"}},
                     {"tile", {"0.01", "0.12", "1"}},
                     {"guard_hairs", {"0", "1", "3000"}},
                     {"width_root", {"0", "0.001", "0.05"}},
                     {"width_tip", {"0", "0.0003", "0.05"}},
                     {"bend", {"0", "2"}},
                     {"curl", {"0", "0.1", "0.5"}},
                     {"curl_turns", {"0", "20"}},
                     {"wave", {"0", "0.5"}},
                     {"mess", share},
                     {"clump", share},
                     {"clump_size", sizes},
                     {"fine_clump", share},
                     {"lodge", share},
                     {"lodge_size", sizes},
                     {"wetness", share},
                     {"length_spread", share},
                     {"colour_spread", share},
                     {"warmth_spread", share},
                     {"root_share", share},
                     {"lean_curve", {"\"arc\"", "\"root\""}},
                     {"seed", seeds},
                     {"tufts", {tufts}},
                     {"pattern", {pattern}},
                     {"variation", {variation}},
                     {"undercoat", {under}}});
}

std::string any_look() {
  const std::string fibre = any_object({{"longitudinal_roughness", {"0", "1e-4", "0.3", "1"}},
                                        {"azimuthal_roughness", {"0", "1e-4", "0.3", "1"}},
                                        {"cuticle_tilt", {"-15", "0", "15"}},
                                        {"refractive_index", {"1", "1.000001", "1.55", "3"}},
                                        {"absorption", {"\"colour\"", "\"melanin\""}},
                                        {"eumelanin", {"0", "1", "1e4"}},
                                        {"pheomelanin", {"0", "1e4"}},
                                        {"highlight_width", {"0", "7", "90"}},
                                        {"caustic_width", {"1", "60"}},
                                        {"primary_shift", {"-2", "2"}},
                                        {"secondary_shift", {"-2", "2"}},
                                        {"shift_spread", {"0", "2"}},
                                        {"secondary_exponent", exponents}});
  return any_object(
      {{"shading",
        {"\"lengyel\"", "\"kajiya\"", "\"energy_conserving\"", "\"scheuermann\"", "\"kajiya_kay\"", "\"marschner\""}},
       {"ambient", {"0", "4"}},
       {"diffuse", {"0", "4"}},
       {"specular", {"0", "4"}},
       {"diffuse_exponent", exponents},
       {"specular_exponent", exponents},
       {"back_attenuation", {"0.001", "1"}},
       {"ambient_floor", share},
       {"self_shadow", {"0", "1", "4"}},
       {"fibre", {fibre}},
       {"skin", colours}});
}

std::string any_light() {
  return any_object({{"kind", {"\"directional\"", "\"point\"", "\"spot\"", "\"area\""}},
                     {"direction", directions},
                     {"position", positions},
                     {"colour", colours},
                     {"intensity", {"0", "1e-3", "1", "1e8"}},
                     {"cone_degrees", {"0.1", "30", "90"}},
                     {"cone_softness", share},
                     {"angle_degrees", {"0", "90"}},
                     {"radius", {"0", "10"}},
                     {"width", {"0.001", "100"}},
                     {"height", {"0.001", "100"}},
                     {"self_shadow_maps", truth},
                     {"cast_shadow", {"\"none\"", "\"hard\"", "\"soft\"", "\"penumbra\""}},
                     {"shadow_scale", {"0", "10", "1000"}}},
                    60);
}

std::string any_eye() {
  const std::string iris = any_object({{"size", {"0.1", "0.95"}}, {"depth", {"0", "0.5"}}, {"relief", {"0", "0.2"}}});
  const std::string pupil = any_object({{"shape", {"\"round\"", "\"slit\""}}, {"size", share}});
  const std::string lids =
      any_object({{"width_degrees", {"1", "90"}}, {"upper_degrees", {"-90", "90"}}, {"lower_degrees", {"-90", "90"}}});
  const std::string more = any_object({{"iris", {iris}},
                                       {"pupil", {pupil}},
                                       {"lids", {lids}},
                                       {"gaze", directions},
                                       {"bulge", share},
                                       {"refraction", {"1", "1.376", "3"}},
                                       {"wetness", share}});
  const std::string fixed =
      R"({"position": )" + any_of(positions) + R"(, "radius": )" + any_of({"1e-6", "0.05", "1", "1e6"});
  return more == "{}" ? fixed + "}" : fixed + ", " + more.substr(1);
}

std::string any_region() {
  const std::string more = any_object({{"softness", {"0", "10"}},
                                       {"shine", share},
                                       {"roughness", {"0.02", "1"}},
                                       {"wetness", share},
                                       {"scatter", share}});
  const std::string fixed = R"({"centre": )" + any_of(positions) + R"(, "radii": )" +
                            any_of({"[1e-6, 1e-6, 1e-6]", "[0.5, 0.5, 0.5]", "[1e6, 1e-6, 1]"});
  return more == "{}" ? fixed + "}" : fixed + ", " + more.substr(1);
}

std::string set(const std::string& op, const std::string& member, const std::string& value) {
  return R"({"op": ")" + op + R"(", ")" + member + "\": " + value + "}";
}

void add_settings(Texts& commands) {
  if (chance(70)) commands.push_back(set("set_coat", "coat", any_coat()));
  if (chance(60)) commands.push_back(set("set_look", "look", any_look()));
  if (chance(70))
    commands.push_back(set("set_lights", "lights", chance(15) ? "[]" : "[" + any_light() + ", " + any_light() + "]"));
  if (chance(30))
    commands.push_back(set("set_environment", "environment",
                           any_object({{"sky", colours}, {"ground", colours}, {"intensity", {"0", "1", "100"}}})));
  if (chance(30))
    commands.push_back(set("set_ground", "ground",
                           any_object({{"visible", truth}, {"height", {"-2", "0", "1e6"}}, {"shadow", share}}, 70)));
  if (chance(30))
    commands.push_back(set("set_wind", "wind",
                           any_object({{"speed", {"0", "0.3", "1e6"}},
                                       {"direction", directions},
                                       {"gusts", {"0", "10"}},
                                       {"turbulence", {"0", "10"}},
                                       {"turbulence_scale", {"0.001", "0.2", "1000"}},
                                       {"frequency", {"0.01", "100"}},
                                       {"damping", {"0.01", "1", "10"}},
                                       {"time", {"-1e6", "0", "1.5", "1e6"}}})));
  if (chance(25)) commands.push_back(set("set_eyes", "eyes", "[" + any_eye() + ", " + any_eye() + "]"));
  if (chance(20)) commands.push_back(set("set_skin", "regions", "[" + any_region() + "]"));
  if (chance(20))
    commands.push_back(set("set_curves", "groups",
                           R"([{"curves": [[[0, 0, 1], )" + any_of(positions) + R"(]], "fill": )" + any_of({"0", "5"}) +
                               R"(, "width_root": )" + any_of({"0", "0.1"}) + "}]"));
}

void add_strokes(Texts& commands) {
  for (const char* field : {"density", "width", "curl", "clump", "wetness", "bare", "stiffness"}) {
    if (chance(15))
      commands.push_back(R"({"op": "paint", "flood": true, "brush": {"strength": 1}, "field": ")" + std::string(field) +
                         R"(", "value": )" + any_of({"0", "0.3", "1"}) + "}");
  }
  if (chance(40))
    commands.push_back(R"({"op": "comb", "flood": true, "brush": {"strength": 1}, "lean": )" + any_of(share) +
                       R"(, "direction": )" + any_of(directions) + "}");
  if (chance(20))
    commands.push_back(R"({"op": "noise", "flood": true, "amount": 10, "feature_size": )" + any_of({"0", "0.1"}) + "}");
}

std::string any_camera() {
  if (chance(40)) return R"({"auto": )" + any_of({"\"front\"", "\"top\"", "\"three_quarter\""}) + "}";
  return R"({"up": [0.1, 1, 0.2], "position": )" +
         any_of({"[0, 0, 1.05]", "[0, 0, 1]", "[0, 0, 0]", "[0, 0, 3.5e7]", "[2, 1, 1]"}) +
         R"(, "target": [1e-3, 2e-3, -1e-3], "fov_degrees": )" + any_of({"1", "30", "150"}) + "}";
}

std::string any_quality() {
  const std::string raster = any_object({{"strands", {"0.01", "0.4", "3", "1000"}}, {"light_of", {"1", "4", "8"}}});
  const std::string shells = any_object({{"count", {"1", "2", "7", "40"}},
                                         {"policy", {"\"uniform\"", "\"adaptive\""}},
                                         {"self_shadow", truth},
                                         {"shadow_maps", truth},
                                         {"shadow_resolution", {"1", "7", "64"}},
                                         {"order", {"\"four_pass\"", "\"sorted\""}}},
                                        50);
  const Texts scales{"0.25", "0.7", "2"};
  if (chance(40)) return any_object({{"scale", scales}, {"shells", {shells}}, {"method", {"\"shells\""}}}, 70);
  return any_object({{"scale", scales}, {"eye_steps", {"0", "1", "64"}}, {"raster", {raster}}}, 50);
}

}  // namespace

std::string any_frame() {
  return R"({"width": )" + any_of({"1", "7", "12"}) + R"(, "height": )" + any_of({"1", "9"}) + R"(, "camera": )" +
         any_camera() + R"(, "quality": )" + any_quality() + R"(, "exposure": )" + any_of({"-20", "0", "20"}) +
         R"(, "background": )" + any_of({"\"transparent\"", "\"studio\"", "\"#102030\""}) + R"(, "tone_map": )" +
         any_of({"\"none\"", "\"filmic\""}) + R"(, "overlay": )" +
         any_of({"\"none\"", "\"none\"", "\"strokes\"", "\"length\"", "\"wetness\""}) + "}";
}

std::string any_tracing() {
  const bool paths = chance(50);
  std::vector<Member> members{{"strands", {"1", "500", "3000"}}, {"noise", share}, {"filter", truth}, {"seed", seeds}};
  if (paths) {
    members.push_back({"bounces", {"1", "8", "4096"}});
  } else {
    members.push_back({"scattering", {"\"look\"", "\"energy_conserving\""}});
  }
  const std::string more = any_object(members, 60);
  const std::string fixed = R"({"method": "strands", "trace": {"passes": )" + any_of({"1", "2"}) +
                            R"(, "transport": )" + (paths ? "\"paths\"" : "\"transmittance\"");
  return (more == "{}" ? fixed + "}" : fixed + ", " + more.substr(1)) + "}";
}

Row any_row() {
  Row row{.area = "any", .value = "scene"};
  if (chance(30)) {
    Rows files = mesh_rows();
    std::erase_if(files, [](const Row& file) { return !file.refused.empty(); });
    row = *rc::gen::elementOf(files);
  } else {
    row.scene = R"({"model": {"builtin": )" + any_of({"\"sphere\"", "\"torus\"", "\"plane\"", "\"cloth\""}) +
                R"(, "triangles": 200}, "fur": {"length": )" + any_of({"0", "1e-6", "0.05", "0.5", "10"}) +
                R"(, "inclination": )" + any_of(share) + "}}";
  }
  add_settings(row.commands);
  add_strokes(row.commands);
  row.frame = any_frame();
  return row;
}

}  // namespace pelage::testing
