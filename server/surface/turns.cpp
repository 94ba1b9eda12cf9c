#include "server/surface/turns.h"

#include <cassert>
#include <cmath>

#include "server/surface/prepare.h"

namespace pelage {

namespace {

/// Sums over the triangles around a vertex: normals with twice the area as length, and the terms of the least-squares
/// map of the edges.
struct VertexSums {
  glm::dvec3 rest_normal{0}, normal{0};
  glm::dvec3 edges_u{0}, edges_v{0};  // sums of moved edges times their rest coordinates
  double uu = 0, uv = 0, vv = 0;      // sums of products of the rest coordinates
  glm::dvec3 u{0}, v{0}, w{0};        // rest frame: tangent, bitangent, normal
};

glm::dvec3 unit_or(glm::dvec3 vector, glm::dvec3 other) {
  const double length = glm::length(vector);
  return length > 0 ? vector / length : other;
}

/// Applies the smallest rotation from one unit vector to another to a vector; any half turn if they are opposite.
glm::dvec3 rotated_between(glm::dvec3 from, glm::dvec3 to, glm::dvec3 vector) {
  const double cosine = glm::dot(from, to);
  if (cosine < -1 + 1e-9) return -vector + 2 * glm::dot(vector, tailward(from)) * tailward(from);
  const glm::dvec3 axis = glm::cross(from, to), across = glm::cross(axis, vector);
  return vector + across + glm::cross(axis, across) / (1 + cosine);
}

glm::dmat3 rotation_of(const VertexSums& sums) {
  const glm::dvec3 normal = unit_or(sums.normal, sums.w);
  const glm::dvec3 x = rotated_between(sums.w, normal, sums.u), y = glm::cross(normal, x);
  // Columns of the map, times a positive determinant, which does not change the rotation.
  const glm::dvec3 u = sums.edges_u * sums.vv - sums.edges_v * sums.uv,
                   v = sums.edges_v * sums.uu - sums.edges_u * sums.uv;
  const double across = glm::dot(u, y) - glm::dot(v, x), along = glm::dot(u, x) + glm::dot(v, y);
  const double length = std::hypot(across, along);
  const glm::dvec2 cos_sin = length > 0 ? glm::dvec2(along, across) / length : glm::dvec2(1, 0);
  const glm::dvec3 tangent = cos_sin.x * x + cos_sin.y * y;
  const glm::dmat3 there(tangent, glm::cross(normal, tangent), normal), rest(sums.u, sums.v, sums.w);
  return there * glm::transpose(rest);
}

std::vector<VertexSums> vertex_sums(const Mesh& rest, std::span<const glm::vec3> positions) {
  std::vector<VertexSums> sums(rest.positions.size());
  const auto each_corner = [&](const auto& use) {
    for (const glm::uvec3& t : rest.triangles) {
      for (int k = 0; k < 3; ++k) use(sums[t[k]], t[k], t[(k + 1) % 3], t[(k + 2) % 3]);
    }
  };
  const auto edge = [](const auto& points, std::uint32_t from, std::uint32_t to) {
    return glm::dvec3(points[to]) - glm::dvec3(points[from]);
  };
  each_corner([&](VertexSums& at, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    at.rest_normal += glm::cross(edge(rest.positions, a, b), edge(rest.positions, a, c));
    at.normal += glm::cross(edge(positions, a, b), edge(positions, a, c));
  });
  for (std::size_t i = 0; i < sums.size(); ++i) {
    VertexSums& at = sums[i];
    at.w = unit_or(at.rest_normal, glm::normalize(glm::dvec3(rest.normals[i])));
    at.u = tailward(at.w), at.v = glm::cross(at.w, at.u);
  }
  each_corner([&](VertexSums& at, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    for (const std::uint32_t other : {b, c}) {
      const glm::dvec3 before = edge(rest.positions, a, other), now = edge(positions, a, other);
      const double u = glm::dot(before, at.u), v = glm::dot(before, at.v);
      at.edges_u += now * u, at.edges_v += now * v;
      at.uu += u * u, at.uv += u * v, at.vv += v * v;
    }
  });
  return sums;
}

}  // namespace

std::vector<glm::dmat3> surface_rotations(const Mesh& rest, std::span<const glm::vec3> positions) {
  assert(positions.size() == rest.positions.size());
  std::vector<glm::dmat3> rotations;
  rotations.reserve(positions.size());
  for (const VertexSums& sums : vertex_sums(rest, positions)) rotations.push_back(rotation_of(sums));
  return rotations;
}

Mesh moved(Mesh rest, std::vector<glm::vec3> positions, std::span<const glm::dmat3> rotations) {
  assert(rotations.size() == rest.positions.size());
  for (std::size_t v = 0; v < rotations.size(); ++v) {
    rest.normals[v] = glm::vec3(rotations[v] * glm::dvec3(rest.normals[v]));
    rest.tangents[v] = glm::vec3(rotations[v] * glm::dvec3(rest.tangents[v]));
  }
  for (std::size_t t = 0; t < rest.shading_normals.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      glm::vec3& normal = rest.shading_normals[t][k];
      normal = glm::vec3(rotations[rest.triangles[t][static_cast<int>(k)]] * glm::dvec3(normal));
    }
  }
  rest.positions = std::move(positions);
  return rest;
}

}  // namespace pelage
