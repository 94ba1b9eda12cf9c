#include "server/export/vertex_colours.h"

#include <algorithm>
#include <cmath>

namespace pelage {

VertexColours::VertexColours(const Surface& surface, const ExportedStrands& strands, std::size_t coat)
    : ramps_(surface.mesh().positions.size()) {
  for (std::size_t k = 0; k < strands.sets.size(); ++k)
    if (strands.group_of[k] == coat) add(strands.sets[k], surface);
  sum_all();
}

VertexColours::VertexColours(std::span<const VertexColours> coats) : ramps_(coats.front().ramps_.size()) {
  for (const VertexColours& coat : coats) {
    for (std::size_t v = 0; v < ramps_.size(); ++v) {
      for (std::size_t h = 0; h < heights; ++h) ramps_[v][h] += coat.ramps_[v][h];
    }
  }
  sum_all();
}

void VertexColours::sum_all() {
  for (const Ramp& ramp : ramps_) {
    for (std::size_t h = 0; h < heights; ++h) all_[h] += ramp[h];
  }
}

void VertexColours::add(const StrandSet& set, const Surface& surface) {
  const std::size_t points = static_cast<std::size_t>(set.segments) + 1;
  for (std::size_t i = 0; i < set.count(); ++i) {
    const SurfacePoint root = surface.nearest(glm::dvec3(set.points[i * points].position));
    const glm::uvec3 corners = surface.mesh().triangles[root.triangle];
    for (std::size_t h = 0; h < heights; ++h) {
      const std::size_t point = i * points + h * static_cast<std::size_t>(set.segments) / (heights - 1);
      const glm::vec4 colour(unpack_colour(set.colours[point]), 1);
      for (int k = 0; k < 3; ++k) ramps_[corners[k]][h] += static_cast<float>(root.barycentric[k]) * colour;
    }
  }
}

glm::vec3 VertexColours::at(std::uint32_t vertex, double s) const {
  const double coordinate = std::clamp(s, 0.0, 1.0) * (heights - 1);
  const auto below = std::min(static_cast<std::size_t>(coordinate), heights - 2);
  const auto mean = [&](std::size_t h) {
    const glm::vec4 own = ramps_[vertex][h], sum = own.w > 1e-3f ? own : all_[h];
    return sum.w > 0 ? glm::vec3(sum) / sum.w : glm::vec3(0);
  };
  return glm::mix(mean(below), mean(below + 1), static_cast<float>(coordinate - static_cast<double>(below)));
}

std::vector<VertexColours> colours_of_coats(const Surface& surface, const ExportedStrands& strands) {
  std::vector<VertexColours> colours;
  for (std::size_t coat = 0; coat < strands.coats(); ++coat) colours.emplace_back(surface, strands, coat);
  return colours;
}

}  // namespace pelage
