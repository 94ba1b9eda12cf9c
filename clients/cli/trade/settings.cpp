#include <fmt/format.h>

#include "clients/cli/trade/cases.h"

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
  collect.choice(base, "order", "layers", [](Knobs& k) { k.order = FragmentOrder::layers; });
  collect.choice(base, "order", "sorted", [](Knobs& k) { k.order = FragmentOrder::sorted; });
  collect.choice(base, "fins", "off", [](Knobs& k) { k.fins = false; });
  collect.choice(base, "fins", "on", [](Knobs& k) { k.fins = true; });
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
  draft.knobs.least_radius = 0;  // its scale as in large pictures: the report's are so small that it would be 1
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
