#include "renderer/strands/root_fields.h"

#include <algorithm>
#include <cmath>

#include "base/lean_curve.h"
#include "renderer/pattern/pattern.h"

namespace pelage {

namespace {
constexpr int inclinations = 256;  // steps between the rows of the table
}

LeanTable::LeanTable(LeanCurve curve, double root_share) : rows_(inclinations + 1) {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const double inclination = static_cast<double>(i) / inclinations;
    for (std::size_t k = 0; k < rows_[i].size(); ++k) {
      const LeanPoint at = lean_point(curve, inclination, root_share, static_cast<double>(k) / lean_cells);
      rows_[i][k] = {glm::vec2(at.across, at.up), glm::vec2(std::sin(at.angle), std::cos(at.angle))};
    }
  }
}

LeanKnot LeanTable::knot(float inclination, std::size_t k) const {
  const float at = std::clamp(inclination, 0.0f, 1.0f) * inclinations;
  const auto low = std::min(static_cast<std::size_t>(at), rows_.size() - 2);
  const float part = at - static_cast<float>(low);
  return {glm::mix(rows_[low][k].position, rows_[low + 1][k].position, part),
          glm::mix(rows_[low][k].slope, rows_[low + 1][k].slope, part)};
}

LeanRow LeanTable::row(float inclination) const {
  LeanRow row;
  for (std::size_t k = 0; k < row.size(); ++k) row[k] = knot(inclination, k);
  return row;
}

namespace {

/// Returns the unit vector along the part of `v` that is orthogonal to `normal`; any orthogonal one where that
/// vanishes.
glm::vec3 unit_across(glm::vec3 v, glm::vec3 normal) {
  const glm::vec3 across = v - normal * glm::dot(v, normal);
  const float length = glm::length(across);
  if (length > 1e-6f) return across / length;
  const glm::vec3 other = std::abs(normal.x) < 0.6f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
  return glm::normalize(other - normal * glm::dot(other, normal));
}

glm::vec3 unit_or_up(glm::vec3 v) {
  const float length = glm::length(v);
  return length > 1e-6f ? v / length : glm::vec3(0, 1, 0);
}

}  // namespace

std::vector<FurVertex> fur_vertices(const FurModel& model, const FurFields& fields) {
  std::vector<FurVertex> vertices(model.positions.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    vertices[v] = fur_vertex(fields, v, model.positions[v], model.normals[v]);
  return vertices;
}

RootFields corner_fields(const FurModel& model, std::span<const FurVertex> vertices, std::uint32_t index, int corner) {
  const std::uint32_t v = model.triangles[index][corner];
  const FurCorner& fur_corner = model.corners[index][static_cast<std::size_t>(corner)];
  const bool moved = !model.rest_positions.empty();
  RootFields root;
  root.position = model.positions[v], root.normal = model.normals[v];
  root.rest.position = moved ? model.rest_positions[v] : root.position;
  root.rest.normal = moved ? model.rest_normals[v] : root.normal;
  root.length = vertices[v].length, root.wetness = vertices[v].wetness;
  root.root_paint = vertices[v].root_paint, root.tip_paint = vertices[v].tip_paint;
  root.image_uv = fur_corner.image_uv, root.colour = fur_corner.colour, root.image = fur_corner.image;
  return root;
}

CornerLean corner_lean(const FurVertex& vertex, glm::vec3 rest_position, glm::vec3 normal, glm::vec3 tangent,
                       const PatternBlock* pattern) {
  const auto [inclination, direction] = lean_of(vertex.direction, normal, tangent);
  CornerLean lean{normal, vertex.length, direction, inclination};
  if (!pattern) return lean;
  lean.length *= pattern_length(*pattern, rest_position);
  lean.inclination = glm::clamp(inclination + pattern_lean(*pattern, rest_position), 0.0f, 1.0f);
  return lean;
}

void LeanCurves::set(int corner, const LeanTable& leans, const CornerLean& lean) {
  Corner& own = corners_[static_cast<std::size_t>(corner)];
  const LeanRow row = leans.row(lean.inclination);
  for (std::size_t k = 0; k < row.size(); ++k) {
    own.curve[k] = lean.length * (row[k].position.x * lean.direction + row[k].position.y * lean.normal);
    own.slope[k] = (lean.length / lean_cells) * (row[k].slope.x * lean.direction + row[k].slope.y * lean.normal);
  }
}

glm::vec3 LeanCurves::at(glm::vec3 share, float s) const {
  const float at = s * lean_cells;
  const auto k = static_cast<std::size_t>(std::clamp(at, 0.0f, lean_cells - 1.0f));
  const float x = at - static_cast<float>(k), y = 1 - x;
  const glm::vec4 weights(y * y * (1 + 2 * x), x * y * y, x * x * (1 + 2 * y), -x * x * y);  // cubic Hermite
  glm::vec3 sum(0);
  for (int i = 0; i < 3; ++i) {
    const Corner& c = corners_[static_cast<std::size_t>(i)];
    sum += share[i] * (weights[0] * c.curve[k] + weights[1] * c.slope[k] + weights[2] * c.curve[k + 1] +
                       weights[3] * c.slope[k + 1]);
  }
  return sum;
}

LeanCurves LeanCurves::less(const LeanCurves& other) const {
  LeanCurves result;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    for (std::size_t k = 0; k <= lean_cells; ++k) {
      result.corners_[i].curve[k] = corners_[i].curve[k] - other.corners_[i].curve[k];
      result.corners_[i].slope[k] = corners_[i].slope[k] - other.corners_[i].slope[k];
    }
  }
  return result;
}

FurTriangle::FurTriangle(const FurModel& model, std::span<const FurVertex> vertices, std::uint32_t index,
                         const LeanTable& leans, const PatternBlock* pattern) {
  const bool moved = !model.rest_positions.empty();
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t v = model.triangles[index][i];
    Corner& corner = corners_[static_cast<std::size_t>(i)];
    corner.position = corner.rest_position = model.positions[v], corner.normal = corner.rest_normal = model.normals[v];
    if (moved) corner.rest_position = model.rest_positions[v], corner.rest_normal = model.rest_normals[v];
    corner.fur = vertices[v], corner.corner = model.corners[index][static_cast<std::size_t>(i)];
    grown_[i] = corner.corner.weight * glm::smoothstep(0.0f, 0.002f, corner.fur.length);
    density_[i] = corner.fur.density;
    const CornerLean lean = corner_lean(corner.fur, corner.rest_position, corner.normal, model.tangents[v], pattern);
    corner.fur.length = lean.length;  // with the pattern's factor
    curves_.set(i, leans, lean);
  }
  const auto of_corners = [&](glm::vec3 Corner::*of) {
    return std::array{corners_[0].*of, corners_[1].*of, corners_[2].*of};
  };
  if (moved) rotation_ = rotation_of_triangle(of_corners(&Corner::rest_position), of_corners(&Corner::position));
}

glm::vec3 FurTriangle::position(glm::vec3 share) const {
  return share.x * corners_[0].position + share.y * corners_[1].position + share.z * corners_[2].position;
}

glm::vec3 FurTriangle::rest_position(glm::vec3 share) const {
  return share.x * corners_[0].rest_position + share.y * corners_[1].rest_position +
         share.z * corners_[2].rest_position;
}

RootFields FurTriangle::fields(glm::vec3 share) const {
  const auto mixed = [&](auto value) {
    return share.x * value(corners_[0]) + share.y * value(corners_[1]) + share.z * value(corners_[2]);
  };
  RootFields root;
  root.position = position(share);
  root.normal = unit_or_up(mixed([](const Corner& c) { return c.normal; }));
  root.rest = {rest_position(share), unit_or_up(mixed([](const Corner& c) { return c.rest_normal; })), rotation_};
  root.tile_u = unit_across(mixed([](const Corner& c) { return c.corner.tile_axis; }), root.normal);
  root.tile_v = glm::cross(root.normal, root.tile_u);
  root.length = mixed([](const Corner& c) { return c.fur.length; });
  root.width = mixed([](const Corner& c) { return c.fur.width; });
  root.wetness = mixed([](const Corner& c) { return c.fur.wetness; });
  root.curl = mixed([](const Corner& c) { return c.fur.curl; });
  root.clump = mixed([](const Corner& c) { return c.fur.clump; });
  root.root_paint = mixed([](const Corner& c) { return c.fur.root_paint; });
  root.tip_paint = mixed([](const Corner& c) { return c.fur.tip_paint; });
  root.image_uv = mixed([](const Corner& c) { return c.corner.image_uv; });
  root.colour = mixed([](const Corner& c) { return c.corner.colour; });
  root.image = corners_[0].corner.image;
  return root;
}

}  // namespace pelage
