// The settings of a scene: everything that it holds besides its fields and its log.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "protocol/commands/command.h"

namespace pelage {

/// A checkpoint.
struct NamedRevision {
  std::string name;
  std::uint64_t revision = 0;
};

/// The settings of a scene; only commands change them. Copying them is compiled once, as for Command.
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
  std::string skin_texture;  // name of a picture; "" for the model's own colours
  std::vector<NamedBlower> blowers;
  std::vector<NamedAttractor> attractors;
  Symmetry symmetry;
  std::vector<NamedRevision> checkpoints;
  std::vector<EditLayer> layers;  // bottom to top
};

/// The settings of a scene at a revision.
struct SettingsAnswer {
  std::uint64_t revision = 0;
  SceneSettings settings;
};

}  // namespace pelage
