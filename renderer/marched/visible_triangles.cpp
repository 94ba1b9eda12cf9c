#include "renderer/marched/visible_triangles.h"

#include <cmath>

#include "protocol/base/clamped_index.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

namespace {

/// Columns, rows and 1, all times the distance along the view.
glm::dvec3 on_picture(const PlainView& view, glm::vec3 place) {
  const glm::dvec4 clip = glm::dmat4(view.to_clip) * glm::dvec4(place, 1);
  return {0.5 * view.width * (clip.w + clip.x), 0.5 * view.height * (clip.w - clip.y), clip.w};
}

}  // namespace

/// The pixels whose middles a triangle may cover; the whole picture where it reaches behind the camera.
PlainRaster::Box PlainRaster::box_of(const glm::dmat3& corners, int width, int height) {
  glm::dvec2 low(1e30), high(-1e30);
  for (int k = 0; k < 3; ++k) {
    if (!(corners[k].z >= double{near_distance})) return {0, 0, width, height};
    const glm::dvec2 at = glm::dvec2(corners[k]) / corners[k].z;
    low = glm::min(low, at), high = glm::max(high, at);
  }
  const auto pixel = [](double at, int count) { return clamped_index(at, 0, count); };
  return {pixel(std::floor(low.x), width), pixel(std::floor(low.y), height), pixel(std::ceil(high.x), width),
          pixel(std::ceil(high.y), height)};
}

PlainRaster::PlainRaster(std::span<const glm::vec3> places, std::span<const glm::uvec3> triangles,
                         const PlainView& view)
    : view_(view) {
  std::vector<glm::dvec3> corners;
  std::vector<double> depths;
  for (const glm::vec3& place : places) {
    corners.push_back(on_picture(view, place));
    depths.push_back(glm::dot(glm::dvec3(view.axis), glm::dvec3(place)) + double{view.axis.w});
  }
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    const glm::uvec3& t = triangles[i];
    const glm::dmat3 of_triangle(corners[t.x], corners[t.y], corners[t.z]);
    if (std::max({of_triangle[0].z, of_triangle[1].z, of_triangle[2].z}) < double{near_distance}) continue;
    if (!(std::abs(glm::determinant(of_triangle)) > 1e-30)) continue;
    const Box box = box_of(of_triangle, view.width, view.height);
    if (box.left >= box.right || box.top >= box.bottom) continue;
    drawn_.push_back({i, box, glm::inverse(of_triangle), {depths[t.x], depths[t.y], depths[t.z]}});
  }
}

VisibleTriangle PlainRaster::at(const Drawn& drawn, int x, int y) {
  const glm::dvec3 over = drawn.to_shares * glm::dvec3(x + 0.5, y + 0.5, 1);
  const double inverse = over.x + over.y + over.z, least = -1e-9 * inverse;
  if (over.x < least || over.y < least || over.z < least || !(inverse > 0)) return {};
  if (inverse * double{near_distance} > 1) return {};
  const glm::dvec3 shares = over / inverse;
  return {drawn.triangle, static_cast<float>(shares.y), static_cast<float>(shares.z),
          static_cast<float>(glm::dot(shares, drawn.depths))};
}

std::vector<VisibleTriangle> visible_triangles(std::span<const glm::vec3> places, std::span<const glm::uvec3> triangles,
                                               const PlainView& view, int threads) {
  std::vector<VisibleTriangle> seen(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  PlainRaster(places, triangles, view).visit(threads, [&](std::size_t pixel, const VisibleTriangle& found) {
    if (!seen[pixel].there() || found.depth < seen[pixel].depth) seen[pixel] = found;
  });
  return seen;
}

}  // namespace pelage
