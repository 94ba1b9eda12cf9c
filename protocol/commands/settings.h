// What a scene holds beside its fields and its log.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/commands/command.h"

namespace pelage {

/// A checkpoint that was made.
struct NamedRevision {
  std::string name;
  std::uint64_t revision = 0;
};

/// Changed by commands alone. Its copies are compiled once, as those of commands are.
struct SceneSettings {
  SceneSettings();
  SceneSettings(const SceneSettings&);
  SceneSettings(SceneSettings&&) noexcept;
  SceneSettings& operator=(const SceneSettings&);
  SceneSettings& operator=(SceneSettings&&) noexcept;
  ~SceneSettings();

  std::vector<NamedCoat> coats{1};  // at least one, and one that is not muted
  Look look;
  std::vector<Light> lights = default_lights();
  Environment environment;
  Ground ground;
  Wind wind;
  std::vector<Eye> eyes;
  std::vector<CurveGroup> curves;
  std::vector<SkinRegion> skin;
  std::string skin_texture;  // "" for the model's own colours
  std::vector<NamedBlower> blowers;
  std::vector<NamedAttractor> attractors;
  Symmetry symmetry;
  std::vector<NamedRevision> checkpoints;
  std::vector<EditLayer> layers;  // from the lowest
};

/// The settings of a scene at a revision.
struct SettingsAnswer {
  std::uint64_t revision = 0;
  SceneSettings settings;
};

}  // namespace pelage
