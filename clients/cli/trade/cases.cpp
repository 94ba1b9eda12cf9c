#include "clients/cli/trade/cases.h"

#include <fmt/format.h>

#include <cmath>

#include "protocol/json/encode.h"

namespace pelage::trade {

namespace {

constexpr double near = 1.35, far = 4;  // sizes from the middle; the model's sphere fills the picture at 1.7

constexpr const char* white = R"({"op":"set_coat","coat":{"ramp":[{"at":0,"colour":"#efeae2"}]}})";
constexpr const char* dark = R"({"op":"set_coat","coat":{"ramp":[{"at":0,"colour":"#221c18"}]}})";

constexpr const char* coat_colours = R"({"op":"set_look","look":{"colour_source":"coat"}})";

glm::dvec3 from(double degrees_up, double degrees_around) {
  const double up = glm::radians(degrees_up), around = glm::radians(degrees_around);
  return {std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around)};
}

/// One light that is seen from behind the eye, or one that shines at it, with a weak one from above.
std::string lights(bool front, glm::dvec3 towards) {
  const glm::dvec3 to = front ? -towards + glm::dvec3{0.4, -0.5, 0} : towards + glm::dvec3{0, -0.6, 0};
  return fmt::format(R"({{"op":"set_lights","lights":[{{"direction":[{:.4f},{:.4f},{:.4f}],"intensity":1.6,)"
                     R"("cast_shadow":"penumbra"}},{{"direction":[0,-1,0.1],"intensity":0.3,"cast_shadow":"penumbra"}}]}})",
                     to.x, to.y, to.z);
}

std::string new_scene(const char* builtin, int triangles) {
  return fmt::format(R"({{"name":"trade","model":{{"builtin":"{}","triangles":{}}},"fur":{{"length":0.035}}}})",
                     builtin, triangles);
}

struct Sight {
  const char* model;
  bool is_white, front, is_near, swept;
  glm::dvec3 direction;
};

Case case_of(const Sight& s, const std::string& words = {}) {
  const bool patch = std::string_view(s.model) == "plane";
  const double distance = s.is_near ? (patch ? 0.9 : near) : far;
  return {
      .name = fmt::format("{}{}, {} coat, lit from {}, {}", patch ? "patch" : s.model, words,
                          s.is_white ? "white" : "dark", s.front ? "the front" : "behind", s.is_near ? "near" : "far"),
      .request = new_scene(s.model, patch ? 800 : 5000),
      .commands = {s.is_white ? white : dark, coat_colours, lights(s.front, s.direction)},
      .towards = s.direction * distance,
      .swept = s.swept};
}

}  // namespace

std::vector<Case> built_in_cases(bool quick) {
  const glm::dvec3 side = from(25, 40);
  if (quick) {
    Case sphere = case_of({"sphere", true, true, true, true, side});
    sphere.request = new_scene("sphere", 300);
    return {sphere};
  }
  return {case_of({"creature", true, true, true, true, side}),
          case_of({"creature", false, true, true, false, side}),
          case_of({"creature", true, false, true, false, side}),
          case_of({"creature", true, true, false, false, side}),
          case_of({"torus", false, true, true, true, side}),
          case_of({"torus", true, false, false, false, side}),
          case_of({"sphere", true, true, true, false, side}),
          case_of({"sphere", false, false, true, false, side}),
          case_of({"plane", true, true, true, false, from(85, 20)}, " seen from above"),
          case_of({"plane", true, true, true, false, from(40, 20)}, " at 50 degrees"),
          case_of({"plane", true, true, true, true, from(12, 20)}, " at 78 degrees")};
}

std::vector<Case> cases_of(const std::string& id, const std::string& name) {
  const glm::dvec3 side = from(20, 35);
  return {{.name = name + ", near", .id = id, .towards = side * near, .swept = true},
          {.name = name + ", far", .id = id, .towards = side * far, .swept = false}};
}

}  // namespace pelage::trade
