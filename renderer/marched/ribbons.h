// Guided curves as a camera sees them: ribbons that face it. The twin of renderer/shaders/ribbon.glsl, sorted among the
// fur.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/curves/curve_strips.h"

namespace pelage {

/// A place on a curve on the picture. Between two of them a ribbon lies where `along` is above the one and below the
/// other.
struct RibbonEnd {
  glm::vec2 at{0};     // pixels from the left and the top
  glm::vec2 along{0};  // across the ribbon's edge, towards the tip, unit; 0 where the curve points at the camera
  float inverse = 0;   // 1 / distance along the view; 0 for what is nearer than near_distance
  float reach = 0;     // half of the drawn width, pixels
  float strength = 0;  // opacity in the middle
  float height = 1;    // in the fur
  glm::vec3 place{0}, tangent{0}, colour{0};
};

struct Ribbon {
  RibbonEnd root, tip;
  glm::vec3 normal{0};  // of the skin at the curve's root
  float number = 0;     // random, [0, 1)
  int hair = -1;        // of MarchScene::hairs; -1 for a guided curve
};

/// The unit vector along `v`; 0 for 0.
inline glm::vec3 unit_of(glm::vec3 v) { return v / std::max(glm::length(v), 1e-20f); }

/// Who looks at ribbons.
struct RibbonCamera {
  glm::mat4 to_clip{1};
  glm::vec3 viewpoint{0};
  float pixel = 0;    // size of a pixel at distance 1
  glm::vec2 size{0};  // pixels of the picture
};

/// A place of a ribbon of that width, sizes, as the camera sees it.
RibbonEnd ribbon_end(glm::vec3 place, glm::vec3 tangent, float width, const RibbonCamera& camera);

/// Those of all curves, one after the other, but for what reaches behind the camera.
std::vector<Ribbon> ribbons_of(const CurveStrips& strips, const RibbonCamera& camera);

/// Where a place lies on a ribbon.
struct OnRibbon {
  float share = 0;    // from root to tip
  float opacity = 0;  // 0 beside it
};
OnRibbon on_ribbon(const Ribbon& ribbon, glm::vec2 pixel);

struct MarchScene;

/// The ribbons of a frame by the tiles of its box.
class Ribbons {
 public:
  Ribbons() = default;
  /// For a scene whose camera and box are there.
  Ribbons(std::vector<Ribbon> ribbons, const MarchScene& scene);

  bool empty() const { return ribbons_.empty(); }
  const Ribbon& operator[](std::uint32_t number) const { return ribbons_[number]; }
  /// Numbers of those that a tile may show, tiles counted from the first of the box row by row.
  std::span<const std::uint32_t> of_tile(std::size_t tile) const {
    return std::span(numbers_).subspan(first_[tile], first_[tile + 1] - first_[tile]);
  }

 private:
  void sort_into_tiles(const MarchScene& scene);

  std::vector<Ribbon> ribbons_;
  std::vector<std::uint32_t> first_, numbers_;  // of each tile, in numbers_; one more at the end
};

}  // namespace pelage
