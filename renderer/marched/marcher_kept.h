// What a marcher keeps from frame to frame; of marcher.cpp and march_scene.cpp alone.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "renderer/coat/slices.h"
#include "renderer/curves/curve_strips.h"
#include "renderer/marched/marcher.h"
#include "renderer/marched/shadow_cache.h"
#include "renderer/pattern/pattern.h"
#include "renderer/pattern/surface_volume.h"

namespace pelage {

/// A coat as it is drawn.
struct Marcher::Coated {
  Coat coat;
  Slices slices;  // without texels, which the atlas has
  SliceAtlas atlas;

  Coated(const Coat& of, const Slices& baked) : coat(of), slices(without_texels(baked)), atlas(baked) {}
};

/// Maps of the shells of a frame's lights.
struct ShellShadows {
  struct Key {
    std::uint64_t model = 0, changes = 0;
    Coat coat;
    std::vector<FurLight> lights;
    int resolution = 0;
    bool operator==(const Key&) const = default;
  };
  Key key;
  std::vector<std::vector<float>> maps;
  std::vector<ShellShadow> shadows;   // of each light
  std::vector<ShadowCaster> casters;  // of the last frame
};

/// What is made once for a look, a model or its curves.
struct Marcher::Kept {
  std::optional<Look> look;
  ScatteringBlock scattering{};
  AzimuthalFit azimuthal;
  std::uint64_t model = 0;
  std::optional<PatternBlock> pattern;
  SurfaceVolume volume;
  std::vector<glm::vec4> variation;
  std::uint64_t tufted = 0;  // the model of the tufts
  std::optional<Tufts> tufts;
  SurfaceVolume tuft_volume;
  std::optional<Coat> clumped;  // whose clumps they are
  std::vector<std::int32_t> clumps;
  float clump_reach = 0;
  std::uint64_t standing = 0;  // the model on the ground
  float ground_height = 0;
  GroundContact contact;
  std::vector<FurCurves> curves;
  CurveStrips strips;        // of those curves
  std::uint64_t haired = 0;  // the model of the hairs
  int hair_count = 0;
  std::vector<HairRoot> hairs;
  ShadowCache shadows;
  ShellShadows shell_shadows;
};

}  // namespace pelage
