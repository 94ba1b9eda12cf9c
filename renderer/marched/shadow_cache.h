// Maps of what lights see, kept until a light, the fur, the coat or the resolution changes.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/curves/curve_strips.h"
#include "renderer/marched/depth_map.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

class ShadowCache {
 public:
  /// Whether a frame's lights have any maps.
  static bool wanted(const FurFrame& frame);

  /// Adds the casters of a frame to its scene, whose mesh and frame block are there, where it has any. `changes`:
  /// FurMesh::changes. Valid until the next call.
  void add(const FurFrame& frame, std::uint64_t changes, const CurveStrips& curves, int threads, MarchScene& scene);

 private:
  struct Key {
    std::uint64_t model = 0, changes = 0;
    double root_share = 0;
    LeanCurve curve = LeanCurve::arc;
    std::vector<FurLight> lights;
    std::vector<FurCurves> curves;
    int resolution = 0;
    bool operator==(const Key&) const = default;
  };
  void make_maps(const FurFrame& frame, const CurveStrips& curves, int threads, const MarchScene& scene);

  Key key_;
  std::vector<ShadowCaster> casters_;
  struct Maps {
    DepthMap depths;
    std::vector<glm::vec2> widths, curves;
  };
  std::vector<Maps> maps_;  // of each light
};

}  // namespace pelage
