#include "renderer/upload/split_corners.h"

#include <algorithm>
#include <numeric>

namespace pelage {

namespace {

bool same_look(const FurCorner& a, const FurCorner& b) {
  return a.tile_uv == b.tile_uv && a.tile_axis == b.tile_axis && a.image_uv == b.image_uv && a.colour == b.colour &&
         a.image == b.image && a.weight == b.weight && a.normal == b.normal;
}

RenderVertex make_vertex(const FurModel& model, std::uint32_t vertex, const FurCorner& corner) {
  return {model.positions[vertex],
          model.normals[vertex],
          model.tangents[vertex],
          corner.tile_uv,
          corner.tile_axis,
          {corner.image_uv, static_cast<float>(corner.image)},
          corner.colour,
          corner.weight,
          corner.normal == glm::vec3(0) ? model.normals[vertex] : corner.normal};
}

}  // namespace

SplitModel split_corners(const FurModel& model) {
  SplitModel split;
  const std::size_t corners = 3 * model.triangles.size();
  const auto vertex_of = [&](std::uint32_t c) { return model.triangles[c / 3][static_cast<int>(c % 3)]; };
  const auto corner_of = [&](std::uint32_t c) -> const FurCorner& { return model.corners[c / 3][c % 3]; };
  std::vector<std::uint32_t> order(corners);
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return vertex_of(a) < vertex_of(b); });

  split.triangles.resize(model.triangles.size());
  split.first.assign(model.positions.size() + 1, 0);
  std::vector<std::uint32_t> chosen;  // the corner that made each render vertex
  for (std::size_t i = 0; i < corners;) {
    const std::uint32_t vertex = vertex_of(order[i]);
    const std::size_t begin = chosen.size();
    for (; i < corners && vertex_of(order[i]) == vertex; ++i) {
      const auto same = std::find_if(chosen.begin() + static_cast<std::ptrdiff_t>(begin), chosen.end(),
                                     [&](auto c) { return same_look(corner_of(c), corner_of(order[i])); });
      const auto index = static_cast<std::uint32_t>(same - chosen.begin());
      if (same == chosen.end()) chosen.push_back(order[i]), split.welded.push_back(vertex);
      split.triangles[order[i] / 3][static_cast<int>(order[i] % 3)] = index;
    }
    split.first[vertex + 1] = static_cast<std::uint32_t>(chosen.size() - begin);
  }
  std::partial_sum(split.first.begin(), split.first.end(), split.first.begin());

  split.vertices.reserve(chosen.size());
  for (const std::uint32_t c : chosen) split.vertices.push_back(make_vertex(model, vertex_of(c), corner_of(c)));
  return split;
}

std::vector<glm::vec3> by_vertex(std::span<const glm::vec3> values, std::span<const std::uint32_t> welded) {
  std::vector<glm::vec3> result;
  result.reserve(values.empty() ? 0 : welded.size());
  for (std::size_t i = 0; i < welded.size() && !values.empty(); ++i) result.push_back(values[welded[i]]);
  return result;
}

}  // namespace pelage
