#include "renderer/marched/near_plane.h"

#include <algorithm>
#include <array>

namespace pelage {

namespace {

using Row = std::vector<float>;

float distance_of(const MarchScene& scene, const Row& row) {
  const glm::vec3 place(row[Varyings::place], row[Varyings::place + 1], row[Varyings::place + 2]);
  return glm::dot(place - scene.viewpoint, scene.forward);
}

/// A vertex whose numbers are themselves, not over the distance.
Row whole_row(const MarchScene& scene, const ShellTriangle& triangle, int corner) {
  const float* from = scene.row(scene.row_of(triangle, corner));
  Row row(from, from + scene.varyings.stride);
  const float inverse = row[Varyings::inverse];
  for (std::size_t i = Varyings::inverse + 1; inverse > 0 && i < row.size(); ++i) row[i] /= inverse;
  return row;
}

Row between(const Row& a, const Row& b, float share) {
  Row row(a.size());
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = a[i] + share * (b[i] - a[i]);
  return row;
}

/// What is left of a triangle (Sutherland and Hodgman 1974).
std::vector<Row> beyond_plane(const MarchScene& scene, const std::array<Row, 3>& corners) {
  std::vector<Row> kept;
  for (std::size_t i = 0; i < 3; ++i) {
    const Row &here = corners[i], &next = corners[(i + 1) % 3];
    const float before = distance_of(scene, here) - near_distance, after = distance_of(scene, next) - near_distance;
    if (before > 0) kept.push_back(here);
    if ((before > 0) != (after > 0)) kept.push_back(between(here, next, before / (before - after)));
  }
  return kept;
}

/// Puts its place on the picture and divides by the distance.
void project(const MarchScene& scene, Row& row) {
  const glm::vec4 place(row[Varyings::place], row[Varyings::place + 1], row[Varyings::place + 2], 1);
  const glm::vec4 clip = scene.optics.frame.world_to_clip * place;
  const float inverse = 1 / std::max(clip.w, near_distance);
  row[Varyings::x] = (clip.x * inverse * 0.5f + 0.5f) * static_cast<float>(scene.width);
  row[Varyings::y] = (0.5f - clip.y * inverse * 0.5f) * static_cast<float>(scene.height);
  row[Varyings::inverse] = inverse;
  for (std::size_t i = Varyings::inverse + 1; i < row.size(); ++i) row[i] *= inverse;
}

}  // namespace

std::vector<ShellTriangle> cut_at_near_plane(MarchScene& scene, const ShellTriangle& triangle) {
  std::vector<Row> polygon = beyond_plane(
      scene, {whole_row(scene, triangle, 0), whole_row(scene, triangle, 1), whole_row(scene, triangle, 2)});
  for (Row& row : polygon) project(scene, row);
  std::vector<ShellTriangle> triangles;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    triangles.push_back(triangle);
    triangles.back().cut =
        static_cast<std::uint32_t>(scene.vertices.size() / static_cast<std::size_t>(scene.varyings.stride));
    for (const Row* row : {&polygon[0], &polygon[i - 1], &polygon[i]})
      scene.vertices.insert(scene.vertices.end(), row->begin(), row->end());
  }
  return triangles;
}

}  // namespace pelage
