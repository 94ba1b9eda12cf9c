// Triangles over the middles of pixels: what shadow maps, overlays and other pictures of plain surfaces are made from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "protocol/base/parallel.h"

namespace pelage {

struct VisibleTriangle {
  static constexpr std::uint32_t none = 0xffffffff;
  std::uint32_t triangle = none;
  float second = 0, third = 0;  // shares of its second and third corner, in space
  float depth = 0;

  bool there() const { return triangle != none; }
};

/// Between the corners' values.
template <class T>
T at_visible(const VisibleTriangle& seen, const T& first, const T& second, const T& third) {
  return first + seen.second * (second - first) + seen.third * (third - first);
}

/// A perspective or a parallel view.
struct PlainView {
  glm::mat4 to_clip{1};
  glm::vec4 axis{0};  // depth: dot(xyz, place) + w, sizes
  int width = 0, height = 0;
};

/// Triangles as a view shows them. What reaches behind the camera is there as far as it is not nearer than
/// near_distance (Olano and Greer 1997, "Triangle scan conversion using 2D homogeneous coordinates").
class PlainRaster {
 public:
  PlainRaster(std::span<const glm::vec3> places, std::span<const glm::uvec3> triangles, const PlainView& view);

  /// Calls visit(pixel, VisibleTriangle) for each triangle over each pixel, rows from the top; at one pixel in the
  /// order of the triangles and on one thread.
  template <class Visit>
  void visit(int threads, const Visit& visit) const {
    const auto bands = static_cast<std::uint32_t>((view_.height + band_rows - 1) / band_rows);
    for_each_in_parallel(
        bands, [&](std::uint32_t band) { visit_band(static_cast<int>(band) * band_rows, visit); }, threads);
  }

 private:
  static constexpr int band_rows = 32;

  /// Half-open, pixels.
  struct Box {
    int left = 0, top = 0, right = 0, bottom = 0;
  };
  /// `to_shares` takes (x, y, 1) to the corners' shares over the distance.
  struct Drawn {
    std::uint32_t triangle = 0;
    Box box;
    glm::dmat3 to_shares{1};
    glm::dvec3 depths{0};
  };
  static Box box_of(const glm::dmat3& corners, int width, int height);
  /// Not there beside the triangle.
  static VisibleTriangle at(const Drawn& drawn, int x, int y);

  template <class Visit>
  void visit_band(int top, const Visit& visit) const {
    const int bottom = std::min(view_.height, top + band_rows);
    for (const Drawn& drawn : drawn_) {
      for (int y = std::max(top, drawn.box.top); y < std::min(bottom, drawn.box.bottom); ++y) {
        for (int x = drawn.box.left; x < drawn.box.right; ++x) {
          const VisibleTriangle found = at(drawn, x, y);
          if (found.there())
            visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) + static_cast<std::size_t>(x),
                  found);
        }
      }
    }
  }

  PlainView view_;
  std::vector<Drawn> drawn_;
};

/// The nearest of each pixel; of triangles at the same depth the first. The same for any number of threads.
std::vector<VisibleTriangle> visible_triangles(std::span<const glm::vec3> places, std::span<const glm::uvec3> triangles,
                                               const PlainView& view, int threads);

}  // namespace pelage
