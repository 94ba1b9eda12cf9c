// Which pixels of a tile a triangle covers, and what it brings to each: groups of pixels side by side, one for each
// lane.
#if defined(PELAGE_MARCHED_RASTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_RASTER_INL_H_
#undef PELAGE_MARCHED_RASTER_INL_H_
#else
#define PELAGE_MARCHED_RASTER_INL_H_
#endif

#include <algorithm>
#include <cmath>

#include "renderer/marched/crossings.h"
#include "renderer/marched/march_scene.h"
#include "renderer/optics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Pixels of a group: as square as the lanes allow.
inline constexpr int group_width = lane_count >= 8 ? 4 : lane_count >= 2 ? 2 : 1;
inline constexpr int group_height = lane_count / group_width;
inline constexpr int groups_across = Tile::side / group_width, groups_down = Tile::side / group_height;

HWY_INLINE Real lanes_x() {
  float x[lane_count];
  for (int i = 0; i < lane_count; ++i) x[i] = static_cast<float>(i % group_width) + 0.5f;
  return load(x);
}
HWY_INLINE Real lanes_y() {
  float y[lane_count];
  for (int i = 0; i < lane_count; ++i) y[i] = static_cast<float>(i / group_width) + 0.5f;
  return load(y);
}

/// Of the rays of a group's pixels, 1 along the view.
HWY_INLINE Vec3 way_of(const MarchScene& scene, int left, int top) {
  const Real x = lanes_x() + static_cast<float>(left), y = lanes_y() + static_cast<float>(top);
  return Vec3(scene.ray_0) + x * Vec3(scene.ray_x) + y * Vec3(scene.ray_y);
}

/// One side of a triangle. Both triangles at a side compute the same number for a pixel, so that it belongs to just
/// one.
struct Side {
  float x = 0, y = 0, dx = 0, dy = 0;
  float sign = 1;  // times the number is above 0 inside

  HWY_INLINE Real at(Real px, Real py) const { return (px - x) * dy - (py - y) * dx; }
  HWY_INLINE Mask inside(Real value) const { return sign > 0 ? value >= 0.0f : value < 0.0f; }
};

HWY_INLINE Side side_of(const float* a, const float* b, float orientation) {
  const bool swapped = b[0] < a[0] || (b[0] == a[0] && b[1] < a[1]);
  if (swapped) std::swap(a, b);
  return {a[0], a[1], b[0] - a[0], b[1] - a[1], swapped ? -orientation : orientation};
}

/// A triangle on the picture. `area` is twice its own and above 0.
struct Setup {
  const float* corner[3];
  Side side[3];  // opposite to each corner
  float over_area = 0;
  int left = 0, right = -1, top = 0, bottom = -1;  // groups of the tile that it may touch; none where right < left
};

HWY_INLINE Setup setup_of(const MarchScene& scene, const Tile& tile, const ShellTriangle& triangle) {
  Setup setup;
  for (int k = 0; k < 3; ++k) setup.corner[k] = scene.row(scene.row_of(triangle, k));
  const float *a = setup.corner[0], *b = setup.corner[1], *c = setup.corner[2];
  const float area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  if (!(std::abs(area) > 1e-12f)) return setup;
  const float orientation = area > 0 ? -1.0f : 1.0f;
  setup.over_area = 1 / std::abs(area);
  setup.side[0] = side_of(b, c, orientation), setup.side[1] = side_of(c, a, orientation);
  setup.side[2] = side_of(a, b, orientation);
  const auto range = [](float low, float high, int begin, int size, int& first, int& last) {
    const float end = static_cast<float>(Tile::side);
    first = static_cast<int>(std::clamp(low - static_cast<float>(begin), 0.0f, end)) / size;
    last = static_cast<int>(std::clamp(high - static_cast<float>(begin), -1.0f, end - 1)) / size;
    if (high < static_cast<float>(begin)) last = -1;
  };
  range(std::min({a[0], b[0], c[0]}), std::max({a[0], b[0], c[0]}), tile.left, group_width, setup.left, setup.right);
  range(std::min({a[1], b[1], c[1]}), std::max({a[1], b[1], c[1]}), tile.top, group_height, setup.top, setup.bottom);
  return setup;
}

/// Where pixels lie in a triangle: shares of its second and third corner.
struct Inside {
  Mask mask;
  Real second, third;
};

HWY_INLINE Inside inside_of(const Setup& setup, Real px, Real py) {
  const Real e0 = setup.side[0].at(px, py), e1 = setup.side[1].at(px, py), e2 = setup.side[2].at(px, py);
  return {setup.side[0].inside(e0) & setup.side[1].inside(e1) & setup.side[2].inside(e2),
          e1 * (setup.side[1].sign * setup.over_area), e2 * (setup.side[2].sign * setup.over_area)};
}

HWY_INLINE Real at_inside(const Setup& setup, const Inside& inside, int row) {
  const float a = setup.corner[0][row];
  return mul_add(inside.second, setup.corner[1][row] - a, mul_add(inside.third, setup.corner[2][row] - a, a));
}

/// Calls `visit(group, px, py)` for the groups that the triangle may touch.
template <class Visit>
HWY_INLINE void for_each_group(const Tile& tile, const Setup& setup, Visit visit) {
  const Real lx = lanes_x(), ly = lanes_y();
  for (int y = setup.top; y <= setup.bottom; ++y) {
    for (int x = setup.left; x <= setup.right; ++x)
      visit(y * groups_across + x, lx + static_cast<float>(tile.left + x * group_width),
            ly + static_cast<float>(tile.top + y * group_height));
  }
}

/// The nearest skin of each pixel.
HWY_INLINE void raster_skin(const MarchScene& scene, const Tile& tile, TileScratch& scratch) {
  for (const ShellTriangle& triangle : tile.triangles) {
    if (triangle.shell != 0) continue;
    const Setup setup = setup_of(scene, tile, triangle);
    const auto piece = static_cast<std::int32_t>(triangle.facing ? triangle.piece : ~triangle.piece);
    for_each_group(tile, setup, [&](int group, Real px, Real py) HWY_ATTR {
      const Inside inside = inside_of(setup, px, py);
      if (!any(inside.mask)) return;
      SkinPixels& skin = scratch.skin;
      float* depth = &skin.inverse[static_cast<std::size_t>(group * lane_count)];
      const Real inverse = at_inside(setup, inside, Varyings::inverse);
      const Mask nearer = inside.mask & (inverse > load(depth));
      if (!any(nearer)) return;
      const std::ptrdiff_t at = depth - skin.inverse.data();
      store(select(nearer, inverse, load(depth)), depth);
      store(select(nearer, inside.second, load(&skin.second[static_cast<std::size_t>(at)])),
            &skin.second[static_cast<std::size_t>(at)]);
      store(select(nearer, inside.third, load(&skin.third[static_cast<std::size_t>(at)])),
            &skin.third[static_cast<std::size_t>(at)]);
      const std::uint32_t bits = bits_of(nearer);
      for (auto pixel = static_cast<std::size_t>(at); pixel < static_cast<std::size_t>(at + lane_count); ++pixel) {
        if (bits >> (pixel - static_cast<std::size_t>(at)) & 1)
          skin.piece[pixel] = piece, skin.cut[pixel] = triangle.cut;
      }
    });
  }
}

/// How dense strands lie on a triangle of a shell over those on the tile: density_here of slab.glsl.
HWY_INLINE float density_of(const MarchScene& scene, const ShellTriangle& triangle, const Setup& setup) {
  const auto place = [&](int k) {
    const float* p = setup.corner[k] + Varyings::place;
    return glm::vec3(p[0], p[1], p[2]);
  };
  const glm::uvec3& t = scene.mesh.triangles[triangle.piece];
  const glm::vec3 normal =
      scene.mesh.shading_normals[t.x] + scene.mesh.shading_normals[t.y] + scene.mesh.shading_normals[t.z];
  const float size = std::sqrt(std::max(glm::dot(normal, normal), 1e-20f));
  const float area = 0.5f * std::abs(glm::dot(glm::cross(place(1) - place(0), place(2) - place(0)), normal)) / size;
  return std::clamp(scene.mesh.axes[triangle.piece].tile_area / std::max(area, 1e-30f), 0.16f, 1.7f);
}

/// Records of what each triangle brings to each group that it covers before the skin and the eyes.
HWY_INLINE void raster_fur(const MarchScene& scene, const Tile& tile, TileScratch& scratch) {
  const int count = scene.varyings.count();
  const float* nearest = scratch.nearest();
  for (const ShellTriangle& triangle : tile.triangles) {
    if (triangle.shell == 0 && !triangle.facing) continue;
    const Setup setup = setup_of(scene, tile, triangle);
    if (setup.right < setup.left || setup.bottom < setup.top) continue;
    Record record;
    record.piece = triangle.piece, record.patch = scene.mesh.patches[triangle.piece];
    record.height = scene.shells.heights[triangle.shell], record.facing = triangle.facing;
    record.outermost = triangle.shell + 1 == scene.shells.count();
    record.dense = density_of(scene, triangle, setup);
    for_each_group(tile, setup, [&](int group, Real px, Real py) HWY_ATTR {
      const Inside inside = inside_of(setup, px, py);
      if (!any(inside.mask)) return;
      const Real inverse = at_inside(setup, inside, Varyings::inverse);
      const Real behind = load(nearest + group * lane_count);
      const Mask seen = inside.mask & (inverse > 0.0f) & (inverse >= behind * 0.9999995f);
      if (!any(seen)) return;
      record.lanes = bits_of(seen);
      float* values = scratch.add(record, group, count * lane_count);
      store(inverse, values);
      for (int row = 1; row < count; ++row)
        store(at_inside(setup, inside, Varyings::first + row), values + row * lane_count);
    });
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
