// The scenes that are measured, and the knobs that are tried on them.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "protocol/commands/frame.h"

namespace pelage::trade {

/// A scene seen from one place.
struct Case {
  std::string name;
  std::string id = {};                     // of a scene that is there already; "" to make one
  std::string request = {};                // JSON that makes it
  std::vector<std::string> commands = {};  // JSON, then done to it
  glm::dvec3 towards{0};                   // from the middle of its box to the eye, in sizes
  bool swept = false;                      // all knobs, pictures and R2; else tiers and shells
};

/// Sphere, flat patch at three angles, torus and creature; white and dark, lit from the front and from behind, near and
/// far. `quick`: one small sphere.
std::vector<Case> built_in_cases(bool quick);

/// A scene of the user's as it is, near and far.
std::vector<Case> cases_of(const std::string& id, const std::string& name);

/// One setting of the knobs; see Row.
struct Setting {
  std::string series, base, value;
  Knobs knobs;
};

/// Tiers and shells; with `swept` every knob around the tiers and a grid of shells, steps and scale as well. `quick`
/// leaves most values out.
std::vector<Setting> settings_for(bool swept, bool quick);

}  // namespace pelage::trade
