#include "clients/cli/trade/cases.h"

#include <fmt/format.h>

#include <cmath>

#include "protocol/json/encode.h"

namespace pelage::trade {

namespace {

constexpr double near_distance = 1.35,
                 far_distance = 4;  // sizes from the middle; the model's sphere fills the picture at 1.7

constexpr const char* white = R"({"op":"set_coat","coat":{"ramp":[{"at":0,"colour":"#efeae2"}]}})";
constexpr const char* dark = R"({"op":"set_coat","coat":{"ramp":[{"at":0,"colour":"#221c18"}]}})";

constexpr const char* coat_colours = R"({"op":"set_look","look":{"colour_source":"coat"}})";

glm::dvec3 from(double degrees_up, double degrees_around) {
  const double up = glm::radians(degrees_up), around = glm::radians(degrees_around);
  return {std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around)};
}

/// One light that is seen from behind the camera, or one that shines at it, with a weak one from above.
std::string lights(bool front, glm::dvec3 towards) {
  const glm::dvec3 to = front ? -towards + glm::dvec3{0.4, -0.5, 0} : towards + glm::dvec3{0, -0.6, 0};
  return fmt::format(
      R"({{"op":"set_lights","lights":[{{"direction":[{:.4f},{:.4f},{:.4f}],"intensity":1.6,)"
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
  const double distance = s.is_near ? (patch ? 0.9 : near_distance) : far_distance;
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
  return {{.name = name + ", near", .id = id, .towards = side * near_distance, .swept = true},
          {.name = name + ", far", .id = id, .towards = side * far_distance, .swept = false}};
}

}  // namespace pelage::trade

namespace pelage::trade {

namespace {

struct Base {
  const char* name;
  Knobs knobs;
};

/// Collects settings of one tier.
class Collector {
 public:
  explicit Collector(std::vector<Setting>& settings) : settings_(settings) {}

  template <class T, class Values>
  void numbers(const Base& base, const char* name, T Knobs::*knob, const Values& values) {
    for (const T value : values) {
      Setting setting{name, base.name, fmt::format("{:g}", static_cast<double>(value)), base.knobs};
      setting.knobs.*knob = value;
      settings_.push_back(setting);
    }
  }

  /// Names and what they do to the tier's knobs.
  template <class Change>
  void choice(const Base& base, const char* name, const char* value, Change change) {
    Setting setting{name, base.name, value, base.knobs};
    change(setting.knobs);
    settings_.push_back(setting);
  }

 private:
  std::vector<Setting>& settings_;
};

void add_tiers(std::vector<Setting>& settings) {
  settings.push_back({"tier", "", "draft", knobs_of(Tier::draft)});
  settings.push_back({"tier", "", "interactive", knobs_of(Tier::interactive)});
  settings.push_back({"tier", "", "detailed", knobs_of(Tier::detailed)});
}

void add_numbers(Collector& collect, const Base& base, bool quick) {
  using Ints = std::vector<int>;
  using Reals = std::vector<double>;
  collect.numbers(base, "steps", &Knobs::steps, quick ? Ints{1, 4} : Ints{1, 2, 4, 8});
  collect.numbers(base, "scale", &Knobs::scale, quick ? Reals{0.5, 1} : Reals{0.5, 0.67, 0.75, 1, 1.5});
}

void add_choices(Collector& collect, const Base& base) {
  collect.choice(base, "shell policy", "uniform", [](Knobs& k) { k.shell_policy = ShellPolicy::uniform; });
  collect.choice(base, "shell policy", "adaptive", [](Knobs& k) { k.shell_policy = ShellPolicy::adaptive; });
  collect.choice(base, "order", "shells", [](Knobs& k) { k.order = FragmentOrder::shells; });
  collect.choice(base, "order", "sorted", [](Knobs& k) { k.order = FragmentOrder::sorted; });
  collect.numbers(base, "guard hairs", &Knobs::guard_hairs, std::vector<int>{0, 5000, 20000});
}

void add_grid(std::vector<Setting>& settings, bool quick) {
  using Ints = std::vector<int>;
  Knobs knobs = knobs_of(Tier::interactive);
  for (const int shells : quick ? Ints{4, 8} : Ints{2, 4, 8, 16, 32}) {
    for (const int steps : quick ? Ints{2} : Ints{1, 3, 6}) {
      for (const double scale : {0.5, 0.75, 1.0}) {
        knobs.shells = shells, knobs.steps = steps, knobs.scale = scale;
        settings.push_back({"grid", "", fmt::format("{} x {} x {:g}", shells, steps, scale), knobs});
      }
    }
  }
}

}  // namespace

std::vector<Setting> settings_for(bool swept, bool quick) {
  using Ints = std::vector<int>;
  const Ints shells = quick ? Ints{4, 16} : Ints{2, 4, 8, 16, 32, 64};
  Base draft{"draft", knobs_of(Tier::draft)};
  draft.knobs.min_radius = 0;  // its scale as in large pictures: the report's are so small that it would be 1
  const Base interactive{"interactive", knobs_of(Tier::interactive)};
  std::vector<Setting> settings;
  Collector collect(settings);
  add_tiers(settings);
  collect.numbers(interactive, "shells", &Knobs::shells, shells);
  if (!swept) return settings;
  collect.numbers(draft, "shells", &Knobs::shells, shells);
  add_numbers(collect, draft, quick);
  add_numbers(collect, interactive, quick);
  if (!quick) add_choices(collect, interactive);
  add_grid(settings, quick);
  return settings;
}

}  // namespace pelage::trade
