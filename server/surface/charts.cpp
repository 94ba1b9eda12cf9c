#include "server/surface/charts.h"

#include <cmath>
#include <span>

#include "server/surface/adjacency.h"
#include "server/surface/frames.h"

namespace pelage {

namespace {

constexpr std::uint32_t no_chart = 0xffffffff;

/// Twice the area of each triangle, along its normal.
std::vector<glm::dvec3> area_vectors(const Mesh& mesh) {
  std::vector<glm::dvec3> vectors;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.positions[t.x]), b(mesh.positions[t.y]), c(mesh.positions[t.z]);
    vectors.push_back(glm::cross(b - a, c - a));
  }
  return vectors;
}

/// The triangle's own normal; that of its vertices where 32 bits leave it no area.
glm::dvec3 unit_normal(const Mesh& mesh, std::uint32_t triangle, glm::dvec3 area_vector) {
  const double length = glm::length(area_vector);
  return length > 0 ? area_vector / length : glm::dvec3(mesh.normals[mesh.triangles[triangle].x]);
}

/// Triangles across the sides of each triangle, in rising order of edges.
Adjacency triangles_across(const Mesh& mesh) {
  const std::vector<Side> sides = sorted_sides(mesh.triangles);
  const auto for_each_pair = [&](auto visit) {
    for_each_edge(sides, [&](std::span<const Side> edge) {
      if (edge.size() == 2) {
        visit(edge[0].triangle, edge[1].triangle);
        visit(edge[1].triangle, edge[0].triangle);
      }
    });
  };
  Adjacency across;
  across.begin.assign(mesh.triangles.size() + 1, 0);
  for_each_pair([&](std::uint32_t from, std::uint32_t) { ++across.begin[from + 1]; });
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) across.begin[t + 1] += across.begin[t];
  across.others.resize(across.begin.back());
  std::vector<std::uint32_t> next(across.begin.begin(), across.begin.end() - 1);
  for_each_pair([&](std::uint32_t from, std::uint32_t to) { across.others[next[from]++] = to; });
  return across;
}

/// The frame of a chart: its mean normal, and u along the surface part of the mean tangent.
struct ChartFrame {
  glm::dvec3 u, v;
};

ChartFrame frame_of(const Mesh& mesh, std::span<const std::uint32_t> members, const std::vector<glm::dvec3>& areas,
                    glm::dvec3 first_normal) {
  glm::dvec3 normal(0), tangent(0);
  for (std::uint32_t t : members) {
    normal += areas[t];
    for (int k = 0; k < 3; ++k) tangent += glm::length(areas[t]) * glm::dvec3(mesh.tangents[mesh.triangles[t][k]]);
  }
  const double length = glm::length(normal);
  normal = length > 0 ? normal / length : first_normal;
  const glm::dvec3 along = tangent - glm::dot(tangent, normal) * normal;
  const bool cancelled = !(glm::length(along) > 1e-6 * length);
  const glm::dvec3 u = cancelled ? tailward(normal) : glm::normalize(along);
  return {u, glm::cross(normal, u)};
}

/// Grows one chart after the other.
class ChartGrower {
 public:
  ChartGrower(const Mesh& mesh, double limit_degrees)
      : mesh_(mesh),
        areas_(area_vectors(mesh)),
        across_(triangles_across(mesh)),
        smallest_cosine_(std::cos(glm::radians(limit_degrees))) {
    map_.chart.assign(mesh.triangles.size(), no_chart);
    map_.corner_uv.resize(mesh.triangles.size());
  }

  TileMap grow_all() {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (map_.chart[t] == no_chart) lay(grow(t));
    }
    return std::move(map_);
  }

 private:
  std::vector<std::uint32_t> grow(std::uint32_t seed) {
    const auto chart = static_cast<std::uint32_t>(map_.axis.size());
    const glm::dvec3 first = unit_normal(mesh_, seed, areas_[seed]);
    std::vector<std::uint32_t> members = {seed};
    map_.chart[seed] = chart;
    for (std::size_t i = 0; i < members.size(); ++i) {
      for (std::uint32_t next : across_.of(members[i])) {
        if (map_.chart[next] != no_chart) continue;
        if (glm::dot(unit_normal(mesh_, next, areas_[next]), first) < smallest_cosine_) continue;
        map_.chart[next] = chart;
        members.push_back(next);
      }
    }
    return members;
  }

  void lay(const std::vector<std::uint32_t>& members) {
    const std::uint32_t seed = members.front();
    const ChartFrame frame = frame_of(mesh_, members, areas_, unit_normal(mesh_, seed, areas_[seed]));
    map_.axis.emplace_back(frame.u);
    for (std::uint32_t t : members) {
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec3 p(mesh_.positions[mesh_.triangles[t][static_cast<int>(k)]]);
        map_.corner_uv[t][k] = {glm::dot(p, frame.u), glm::dot(p, frame.v)};
      }
    }
  }

  const Mesh& mesh_;
  std::vector<glm::dvec3> areas_;
  Adjacency across_;
  double smallest_cosine_;
  TileMap map_;
};

}  // namespace

TileMap lay_charts(const Mesh& mesh, double limit_degrees) { return ChartGrower(mesh, limit_degrees).grow_all(); }

}  // namespace pelage
