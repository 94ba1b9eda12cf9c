#include "renderer/visibility/fur_work.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr double triangle_work = 3;  // a software GL sets up a triangle in the time of so many fragments

/// Pixels that a triangle of the skin covers; all for one that reaches behind the eye.
double covered_pixels(const ShellMesh& mesh, const glm::uvec3& t, const glm::mat4& to_clip, double picture) {
  glm::dvec2 corners[3];
  for (int k = 0; k < 3; ++k) {
    const glm::dvec4 clip = to_clip * glm::vec4(mesh.positions[t[k]], 1);
    if (!(clip.w > 0)) return picture;
    corners[k] = glm::dvec2(clip) / clip.w;
  }
  const glm::dvec2 a = corners[1] - corners[0], b = corners[2] - corners[0];
  return std::min(picture, 0.125 * picture * std::abs(a.x * b.y - a.y * b.x));  // clip space is 2 wide and 2 high
}

}  // namespace

FurWork::FurWork(const ShellMesh& mesh, const ShellView& view, glm::ivec2 pixels) {
  const double picture = static_cast<double>(pixels.x) * pixels.y;
  const ShellLists lists = sort_triangles(mesh, view);
  for (const ShellLists::OfSets* sets : {&lists.facing, &lists.back_facing}) {
    for (std::size_t set = 0; set < sets->size(); ++set) {
      const int shells = shells_of_set(view.shells, static_cast<int>(set));
      for (const glm::uvec3& t : (*sets)[set])
        add(cells_of(mesh, t), shells * (triangle_work + covered_pixels(mesh, t, view.to_clip, picture)));
    }
  }
}

void FurWork::add(const CellBox& reached, double work) {
  const glm::ivec2 low = glm::clamp(glm::ivec2(reached.left, reached.low), 0, cells_a_side - 1);
  const glm::ivec2 high = glm::clamp(glm::ivec2(reached.right, reached.high), low, glm::ivec2(cells_a_side - 1));
  const double share = work / ((high.x - low.x + 1) * (high.y - low.y + 1));
  for (int y = low.y; y <= high.y; ++y) {
    for (int x = low.x; x <= high.x; ++x) cells_[static_cast<std::size_t>(y * cells_a_side + x)] += share;
  }
}

double FurWork::in(const glm::dvec2& low, const glm::dvec2& high) const {
  const glm::dvec2 from = glm::clamp(low, 0.0, 1.0) * double{cells_a_side},
                   to = glm::clamp(high, 0.0, 1.0) * double{cells_a_side};
  const auto last = [](double end) { return std::min(cells_a_side - 1, static_cast<int>(end)); };
  const auto overlap = [](int cell, double begin, double end) {
    return std::max(0.0, std::min(end, cell + 1.0) - std::max(begin, static_cast<double>(cell)));
  };
  double work = 0;
  for (int y = static_cast<int>(from.y); y <= last(to.y); ++y) {
    for (int x = static_cast<int>(from.x); x <= last(to.x); ++x) {
      work +=
          cells_[static_cast<std::size_t>(y * cells_a_side + x)] * overlap(x, from.x, to.x) * overlap(y, from.y, to.y);
    }
  }
  return work;
}

}  // namespace pelage
