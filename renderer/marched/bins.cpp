#include "renderer/marched/bins.h"

#include <algorithm>
#include <cmath>

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
    const glm::vec3 to_camera = scene.viewpoint - scene.mesh.positions[t[k]], normal = scene.mesh.normals[t[k]];
    const float size = std::sqrt(std::max(glm::dot(to_camera, to_camera) * glm::dot(normal, normal), 1e-30f));
    const float cosine = glm::dot(to_camera, normal) / size;
    facing.least = std::min(facing.least, cosine), facing.most = std::max(facing.most, cosine);
  }
  return facing;
}

/// Held to what 16 bits can count.
std::int16_t tile_at(float pixel) {
  return static_cast<std::int16_t>(std::floor(std::clamp(pixel / static_cast<float>(Tile::side), -1.0f, 32000.0f)));
}

}  // namespace

Bins::Box Bins::box_of(const MarchScene& scene, int shell, const glm::uvec3& triangle, bool& facing) const {
  const float *a = scene.vertex(shell, triangle.x), *b = scene.vertex(shell, triangle.y),
              *c = scene.vertex(shell, triangle.z);
  constexpr Box none{0, -1, 0, -1};
  constexpr int inverse = Varyings::inverse;
  if (!(a[inverse] > 0 && b[inverse] > 0 && c[inverse] > 0)) return none;
  facing = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) < 0;
  Box box{tile_at(std::min({a[0], b[0], c[0]})), tile_at(std::max({a[0], b[0], c[0]})),
          tile_at(std::min({a[1], b[1], c[1]})), tile_at(std::max({a[1], b[1], c[1]}))};
  clip(box);
  return box.bottom < box.top ? none : box;
}

/// To the tiles that are drawn, counted from the first one.
void Bins::clip(Box& box) const {
  const auto low = [](int value, int first) { return static_cast<std::int16_t>(std::max(value - first, 0)); };
  const auto high = [](int value, int first, int count) {
    return static_cast<std::int16_t>(std::min(value - first, count - 1));
  };
  box = {low(box.left, left_), high(box.right, left_, across_), low(box.top, top_), high(box.bottom, top_, down_)};
}

Bins::Bins(const MarchScene& scene)
    : left_(scene.box.left / Tile::side),
      top_(scene.box.top / Tile::side),
      across_((scene.box.right + Tile::side - 1) / Tile::side - left_),
      down_((scene.box.bottom + Tile::side - 1) / Tile::side - top_) {
  struct Entry {
    ShellTriangle triangle;
    Box box;
  };
  std::vector<Entry> near, far;  // that face the camera, and that do not
  std::vector<Facing> facings;
  for (const glm::uvec3& t : scene.mesh.triangles) facings.push_back(facing_of(scene, t));
  const int shells = scene.shells.count();
  for (int k = shells - 1; k >= 0; --k) {
    const auto shell = static_cast<std::size_t>(k);
    for (std::uint32_t i = 0; i < scene.mesh.triangles.size(); ++i) {
      if (k > 0 && facings[i].most <= furthest_back_facing) continue;
      if (facings[i].least > scene.shells.facing[shell]) continue;
      bool facing = true;
      const Box box = box_of(scene, k, scene.mesh.triangles[i], facing);
      if (!box.empty()) (facing ? near : far).push_back({{i, static_cast<std::uint16_t>(k), facing}, box});
    }
  }
  std::reverse(far.begin(), far.end());
  const auto for_each = [&](auto visit) {
    for (const std::vector<Entry>* list : {&near, &far}) {
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
  return {(left_ + index % across_) * Tile::side, (top_ + index / across_) * Tile::side,
          std::span(triangles_).subspan(first_[at], first_[at + 1] - first_[at])};
}

}  // namespace pelage
