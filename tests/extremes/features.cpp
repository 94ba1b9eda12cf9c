#include "tests/extremes/features.h"

namespace pelage::testing {

namespace {

std::string one(const std::string& op, const std::string& members) {
  return R"({"op": ")" + op + "\", " + members + "}";
}

std::string coat_with(const std::string& members) {
  return one("set_coat", R"("coat": {)" + few_strands + ", " + members + "}");
}

std::string shells(const std::string& members) {
  return R"("quality": {"method": "shells", "shells": {)" + members + "}}";
}

std::string light(const std::string& members) {
  return one("set_lights", R"("lights": [{"direction": [0, -1, -1])" + members + "}]");
}

std::string painted(const std::string& field, const std::string& value) {
  return one("paint", R"("flood": true, "brush": {"strength": 1}, "field": ")" + field + R"(", )" + value);
}

std::string batch(const std::string& first, const std::string& second) {
  return R"({"commands": [)" + first + ", " + second + "]}";
}

std::vector<Feature> of_the_coat() {
  const std::string region = R"({"centre": [0, 0, 1], "radii": [0.5, 0.5, 0.5]})";
  return {
      {"pattern", coat_with(R"("pattern": {"kind": "stripes"})"), "",
       coat_with(R"("pattern": {"kind": "none", "scale": 0.5})")},
      {"variation", coat_with(R"("variation": {"hue": 1})"), "", coat_with(R"("variation": {"hue": 0, "size": 0.3})")},
      {"tufts", coat_with(R"("tufts": {"gather": 1})"), "",
       coat_with(R"("tufts": {"gather": 0, "size": 0.3, "scales": 3})")},
      {"painted density", painted("density", R"("value": 0.5)"), "", painted("density", R"("value": 1)")},
      {"painted colour", painted("root_colour", R"("value": 1, "colour": "#ff0000")"), "",
       painted("wetness", R"("value": 0)")},
      {"bare skin", one("set_skin", R"("regions": [)" + region + "]"), "", one("set_skin", R"("regions": [])")}};
}

std::vector<Feature> of_light() {
  const std::string shine = R"("look": {"shading": "energy_conserving", "fibre": {"refractive_index": 2}})";
  return {{"shadow maps of the shells", light(R"(, "self_shadow_maps": true)"), shells(R"("shadow_maps": true)"),
           light(R"(, "self_shadow_maps": true)"), shells(R"("shadow_resolution": 4096)")},
          {"hard shadow", light(R"(, "cast_shadow": "hard")"), shells(R"("shadow_maps": true)"),
           light(R"(, "cast_shadow": "hard")")},
          {"soft shadow", light(R"(, "cast_shadow": "soft")"), shells(R"("shadow_maps": true)"), light(""),
           shells(R"("shadow_maps": true)")},
          {"penumbra", light(R"(, "cast_shadow": "penumbra")"), shells(R"("shadow_maps": true)"),
           light(R"(, "cast_shadow": "penumbra")")},
          {"light from all around", "", "", one("set_environment", R"("environment": {"intensity": 0.5})")},
          {"wind", "", "", one("set_wind", R"("wind": {"speed": 0, "gusts": 10, "time": 5})"), R"("time": 3)"},
          {"fibre scattering", one("set_look", shine), "",
           one("set_look", R"("look": {"shading": "kajiya", "fibre": {"refractive_index": 2, "eumelanin": 100}})")}};
}

std::vector<Feature> of_the_frame() {
  return {{"sorted order", "", shells(R"("order": "sorted")"), "", shells(R"("order": "four_pass")")},
          {"fewer shells where the view needs fewer", "", shells(R"("policy": "adaptive")"), "",
           shells(R"("policy": "uniform")")},
          {"twice the size", "", R"("quality": {"method": "shells", "scale": 2})", "",
           R"("quality": {"method": "shells", "scale": 1})"}};
}

/// Features that change what tools do, and not how a frame is drawn.
std::vector<Feature> of_the_groom() {
  const std::string aov = one("edit_layer", R"("action": "add", "name": "l")");
  return {{"edit layers", batch(aov, one("length", R"("flood": true, "edit_layer": "l", "mode": "set", "value": 0.1)")),
           "", batch(aov, one("edit_layer", R"("action": "set", "name": "l", "muted": true)"))},
          {"blowers that stay", "", "", one("set_blowers", R"("blowers": [{"name": "b", "source": [0, 0, 3]}])")},
          {"symmetry", "", "", one("set_symmetry", R"("symmetry": {"planes": [{"normal": [1, 0, 0]}]})")},
          {"checkpoints", "", "", one("checkpoint", R"("name": "c")")}};
}

}  // namespace

std::vector<Feature> features() {
  std::vector<Feature> all;
  for (const auto& some : {of_the_coat(), of_light(), of_the_frame(), of_the_groom()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace pelage::testing
