#include "renderer/marched/bins.h"

#include <algorithm>
#include <cmath>

#include "protocol/base/clamped_index.h"
#include "renderer/marched/near_plane.h"
#include "renderer/visibility/shell_lod.h"

namespace pelage {

namespace {

/// The largest and the least cosine between the view and the normals of a triangle's corners.
struct Facing {
  float least = 2, most = -2;
};

Facing facing_of(const MarchScene& scene, const glm::uvec3& t) {
  Facing facing;
  for (int k = 0; k < 3; ++k) {
    const glm::vec3 to_camera = scene.viewpoint - scene.mesh.positions[t[k]], normal = scene.mesh.shading_normals[t[k]];
    const float size = std::sqrt(std::max(glm::dot(to_camera, to_camera) * glm::dot(normal, normal), 1e-30f));
    const float cosine = glm::dot(to_camera, normal) / size;
    facing.least = std::min(facing.least, cosine), facing.most = std::max(facing.most, cosine);
  }
  return facing;
}

/// Held to what 16 bits can count.
std::int16_t tile_at(float pixel) {
  return static_cast<std::int16_t>(clamped_index(std::floor(pixel / static_cast<float>(Tile::side)), -1, 32000));
}

}  // namespace

Bins::Box Bins::box_of(const MarchScene& scene, const ShellTriangle& triangle) const {
  const float *a = scene.row(scene.row_of(triangle, 0)), *b = scene.row(scene.row_of(triangle, 1)),
              *c = scene.row(scene.row_of(triangle, 2));
  Box box{tile_at(std::min({a[0], b[0], c[0]})), tile_at(std::max({a[0], b[0], c[0]})),
          tile_at(std::min({a[1], b[1], c[1]})), tile_at(std::max({a[1], b[1], c[1]}))};
  clip(box);
  return box.bottom < box.top ? Box{0, -1, 0, -1} : box;
}

/// To the tiles that are drawn, counted from the first one.
void Bins::clip(Box& box) const {
  const auto low = [](int value, int first) { return static_cast<std::int16_t>(std::max(value - first, 0)); };
  const auto high = [](int value, int first, int count) {
    return static_cast<std::int16_t>(std::min(value - first, count - 1));
  };
  box = {low(box.left, left_), high(box.right, left_, across_), low(box.top, top_), high(box.bottom, top_, down_)};
}

Bins::Bins(MarchScene& scene)
    : left_(scene.box.left / Tile::side),
      top_(scene.box.top / Tile::side),
      across_((scene.box.right + Tile::side - 1) / Tile::side - left_),
      down_((scene.box.bottom + Tile::side - 1) / Tile::side - top_) {
  std::vector<Facing> facings;
  for (const std::uint32_t piece : scene.pieces) facings.push_back(facing_of(scene, scene.mesh.triangles[piece]));
  Entries entries;
  for (int k = scene.shells.count() - 1; k >= 0; --k) {
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
      if (k > 0 && facings[i].most <= furthest_back_facing) continue;
      if (facings[i].least > scene.shells.facing[static_cast<std::size_t>(k)]) continue;
      add(scene, {scene.pieces[i], static_cast<std::uint16_t>(k), true, 0}, entries);
    }
  }
  std::reverse(entries.far.begin(), entries.far.end());
  fill(entries);
}

void Bins::add(MarchScene& scene, ShellTriangle triangle, Entries& entries) const {
  int before = 0;
  for (int k = 0; k < 3; ++k) before += scene.row(scene.row_of(triangle, k))[Varyings::inverse] > 0 ? 1 : 0;
  if (before == 0) return;
  if (before < 3) {
    for (const ShellTriangle& part : cut_at_near_plane(scene, triangle)) add(scene, part, entries);
    return;
  }
  const Box box = box_of(scene, triangle);
  if (box.empty()) return;
  const float *a = scene.row(scene.row_of(triangle, 0)), *b = scene.row(scene.row_of(triangle, 1)),
              *c = scene.row(scene.row_of(triangle, 2));
  triangle.facing = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0;
  (triangle.facing ? entries.near : entries.far).push_back({triangle, box});
}

void Bins::fill(const Entries& entries) {
  const auto for_each = [&](auto visit) {
    for (const std::vector<Entry>* list : {&entries.near, &entries.far}) {
      for (const Entry& entry : *list) {
        for (int y = entry.box.top; y <= entry.box.bottom; ++y) {
          for (int x = entry.box.left; x <= entry.box.right; ++x)
            visit(static_cast<std::size_t>(y * across_ + x), entry.triangle);
        }
      }
    }
  };
  first_.assign(static_cast<std::size_t>(count()) + 1, 0);
  for_each([&](std::size_t tile, const ShellTriangle&) { ++first_[tile + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  triangles_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for_each([&](std::size_t tile, const ShellTriangle& triangle) { triangles_[next[tile]++] = triangle; });
}

Tile Bins::tile(int index) const {
  const auto at = static_cast<std::size_t>(index);
  return {(left_ + index % across_) * Tile::side, (top_ + index / across_) * Tile::side, at,
          std::span(triangles_).subspan(first_[at], first_[at + 1] - first_[at])};
}

}  // namespace pelage
