#include "renderer/marched/kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/marched/kernels.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep

#include "renderer/marched/curves-inl.h"
#include "renderer/marched/eyes-inl.h"
#include "renderer/marched/ground-inl.h"
#include "renderer/marched/march-inl.h"
#include "renderer/marched/shell_shadow-inl.h"
#include "renderer/marched/skin-inl.h"
#include "renderer/marched/vertices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

void PlaceShellVertices(MarchScene& scene, std::size_t begin, std::size_t end) { place_vertices(scene, begin, end); }

/// Crossings of each lane of a group, sorted, and the segments between them. The most of any lane.
std::size_t find_group_segments(const MarchScene& scene, TileScratch& scratch, int group) {
  for (int lane = 0; lane < lane_count; ++lane) {
    scratch.crossings[static_cast<std::size_t>(lane)].clear();
    scratch.segments[static_cast<std::size_t>(lane)].clear();
  }
  const auto numbers = static_cast<std::size_t>(scene.varyings.count() * lane_count);
  constexpr int u = (Varyings::tile - Varyings::first) * lane_count, v = u + lane_count;
  for (std::uint32_t at = scratch.first[static_cast<std::size_t>(group)]; at != 0; at = scratch.records[at - 1].next) {
    const float* inverse = &scratch.values[(at - 1) * numbers];
    for (std::uint32_t lanes = scratch.records[at - 1].lanes; lanes != 0; lanes &= lanes - 1) {
      const int lane = std::countr_zero(lanes);
      const float distance = 1 / inverse[lane];
      const glm::vec2 place(inverse[u + lane] * distance, inverse[v + lane] * distance);
      scratch.crossings[static_cast<std::size_t>(lane)].push_back({inverse[lane], at - 1, place});
    }
  }
  std::size_t most = 0;
  for (int lane = 0; lane < lane_count; ++lane) {
    const auto at = static_cast<std::size_t>(lane);
    sort_by_depth(scratch.crossings[at]);
    find_segments(scratch.crossings[at], scratch.records, scene.reach, scratch.segments[at]);
    most = std::max(most, scratch.segments[at].size());
  }
  return most;
}

HWY_INLINE Segments segments_at(const MarchScene& scene, const TileScratch& scratch, std::size_t step) {
  Segments segments;
  float highest = 0;
  std::uint32_t there = 0;
  for (int lane = 0; lane < lane_count; ++lane) {
    const std::vector<Segment>& of_lane = scratch.segments[static_cast<std::size_t>(lane)];
    if (step < of_lane.size()) there |= 1u << lane;
  }
  const auto any_lane = static_cast<std::size_t>(std::countr_zero(there));
  for (int lane = 0; lane < lane_count; ++lane) {
    const std::size_t from = there >> lane & 1 ? static_cast<std::size_t>(lane) : any_lane;
    const Segment& segment = scratch.segments[from][step];
    const Record &near = scratch.records[segment.near], &far = scratch.records[segment.far];
    segments.near[lane] = segment.near, segments.far[lane] = segment.far;
    segments.near_height[lane] = near.height, segments.far_height[lane] = far.height;
    highest = std::max(highest, std::abs(near.height - far.height));
    segments.dense[lane] = 0.5f * (near.dense + far.dense);
    segments.piece[lane] = static_cast<std::int32_t>(near.piece);
    segments.lane[lane] = static_cast<std::int32_t>(from);
  }
  segments.there = mask_of_bits(there);
  segments.samples = std::max(static_cast<int>(std::ceil(static_cast<float>(scene.samples) * highest - 0.01f)), 1);
  return segments;
}

HWY_INLINE Ray ray_of(const MarchScene& scene, int left, int top) {
  Ray ray;
  ray.way = way_of(scene, left, top);
  ray.size = length(ray.way), ray.unit_way = ray.way * (1.0f / ray.size);
  float offset[lane_count];
  constexpr float order[16] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};  // of a 4 x 4 dither
  for (int i = 0; i < lane_count; ++i) {
    const int px = left + i % group_width, py = top + i / group_width;
    offset[i] = (order[4 * (py & 3) + (px & 3)] + 0.5f) / 16;
  }
  ray.offset = load(offset);
  return ray;
}

void write_aovs(const MarchScene& scene, int left, int top, const AovSums& sums, AovPixel* aovs) {
  for (int i = 0; i < lane_count; ++i) {
    const int x = left + i % group_width, y = top + i / group_width;
    if (x >= scene.width || y >= scene.height) continue;
    AovPixel& pixel =
        aovs[static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x)];
    for (int row = 0; row < AovRows::count; ++row) pixel[static_cast<std::size_t>(row)] = sums.at(row, i);
  }
}

void write_pixels(const MarchScene& scene, int left, int top, const Vec3& light, Real alpha, float* picture) {
  float numbers[4][lane_count];
  store(light.x, numbers[0]), store(light.y, numbers[1]), store(light.z, numbers[2]), store(alpha, numbers[3]);
  for (int i = 0; i < lane_count; ++i) {
    const int x = left + i % group_width, y = top + i / group_width;
    if (x >= scene.width || y >= scene.height) continue;
    float* to = picture +
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x));
    for (int k = 0; k < 4; ++k) to[k] = numbers[k][i];
  }
}

/// Whether a group shows anything at all.
bool shows_anything(const MarchScene& scene, const TileScratch& scratch, int group, std::uint32_t eyes) {
  const auto first_pixel = static_cast<std::size_t>(group * lane_count);
  const bool curves =
      !scene.ribbons.empty() && scratch.curves.first[first_pixel] != scratch.curves.first[first_pixel + lane_count];
  return scratch.first[static_cast<std::size_t>(group)] != 0 || eyes != 0 || curves || scene.ground.hidden ||
         any(load(&scratch.skin.inverse[first_pixel]) > 0.0f);
}

/// The curves of a group as they are blended.
class GroupCurves {
 public:
  GroupCurves(const MarchScene& scene, const TileScratch& scratch, int group) : scratch_(scratch), group_(group) {
    const auto begin = static_cast<std::size_t>(group * lane_count);
    if (scene.ribbons.empty()) return;
    for (int i = 0; i < lane_count; ++i) next_[i] = scratch.curves.first[begin + static_cast<std::size_t>(i)];
    there_ = next_[0] != scratch.curves.first[begin + lane_count];
  }
  bool there() const { return there_; }
  /// Those that lie before the middle of each lane's segment.
  void see_before(const Segments& segments, const End& near, const End& far, Seen& seen) {
    float until[lane_count];
    store(select(segments.there, 2.0f / (near.distance + far.distance), 1e30f), until);
    see_curves(scratch_, group_, until, next_, seen);
  }
  void see_rest(Seen& seen) {
    const float until[lane_count] = {};
    see_curves(scratch_, group_, until, next_, seen);
  }

 private:
  const TileScratch& scratch_;
  int group_;
  std::uint32_t next_[lane_count] = {};
  bool there_ = false;
};

/// Calls visit(segments, near, far) for the segments of a group from near to far until it answers false.
template <class Visit>
HWY_INLINE void for_each_step(const MarchScene& scene, TileScratch& scratch, int group, const Visit& visit) {
  const std::size_t steps = find_group_segments(scene, scratch, group);
  Segments segments;
  std::optional<End> last;  // mostly where the next segments begin
  for (std::size_t step = 0; step < steps; ++step) {
    const Segments next = segments_at(scene, scratch, step);
    const bool goes_on = last && std::equal(next.near, next.near + lane_count, segments.far);
    segments = next;
    const End near = goes_on ? *last : End(scene, scratch, segments.near, segments.lane);
    const End far(scene, scratch, segments.far, segments.lane);
    if (!visit(segments, near, far)) return;
    last.emplace(far);
  }
}

/// Marches through the fur of a group, with the curves in it.
void see_fur(const MarchScene& scene, const Ray& ray, TileScratch& scratch, int group, Seen& seen) {
  GroupCurves curves(scene, scratch, group);
  bool more = true;
  for_each_step(scene, scratch, group, [&](const Segments& segments, const End& near, const End& far) HWY_ATTR {
    if (curves.there()) curves.see_before(segments, near, far, seen);
    march(scene, ray, segments, near, far, seen);
    return more = any(seen.through > 0.004f);
  });
  if (more && curves.there()) curves.see_rest(seen);
}

/// Behind all fur and eyes.
void see_skin(const MarchScene& scene, const Ray& ray, const TileScratch& scratch, int group, Seen& seen) {
  const SkinPoint skin(scene, scratch.skin, group);
  if (any(skin.there() & (seen.through > 0.002f))) {
    const Real weight = select(skin.there(), seen.through, 0.0f);
    AovSums::Shown shown;
    const Vec3 light = skin_light(scene, ray, skin, seen.aovs ? &shown : nullptr);
    seen.light += select(skin.there(), light, Vec3(0.0f)) * weight;
    if (seen.aovs) seen.aovs->add(shown, weight, seen.through);
  }
  seen.through = select(skin.there(), 0.0f, seen.through);
}

void draw_group(const MarchScene& scene, const Tile& tile, TileScratch& scratch, int group, float* picture,
                AovPixel* aovs) {
  const int left = tile.left + group % groups_across * group_width,
            top = tile.top + group / groups_across * group_height;
  const std::uint32_t eyes = eyes_of(scratch, group);
  std::optional<AovSums> sums;
  if (aovs) sums.emplace();
  Seen seen{Vec3(0.0f), 1.0f, sums ? &*sums : nullptr};
  if (shows_anything(scene, scratch, group, eyes)) {
    const Ray ray = ray_of(scene, left, top);
    see_fur(scene, ray, scratch, group, seen);
    if (eyes != 0) see_eyes(scene, ray, scratch, group, eyes, seen);
    see_skin(scene, ray, scratch, group, seen);
    if (scene.ground.hidden && any(seen.through > 0.002f)) seen.through *= 1.0f - ground_dark(scene, ray);
  }
  write_pixels(scene, left, top, seen.light, 1.0f - seen.through, picture);
  if (aovs) write_aovs(scene, left, top, *sums, aovs);
}

void DrawTile(const MarchScene& scene, const Tile& tile, TileScratch& scratch, float* light, AovPixel* aovs) {
  scratch.clear();
  raster_skin(scene, tile, scratch);
  raster_eyes(scene, tile, scratch);
  if (!scene.ribbons.empty()) raster_curves(scene, tile, aovs != nullptr, scratch);
  if (!scene.bare) raster_fur(scene, tile, scratch);
  for (int group = 0; group < groups_across * groups_down; ++group)
    draw_group(scene, tile, scratch, group, light, aovs);
}

void write_kept(const MarchScene& scene, int left, int top, const KeptLight& kept, float* maps) {
  const std::size_t texels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
  for (int i = 0; i < lane_count; ++i) {
    const int x = left + i % group_width, y = top + i / group_width;
    if (x >= scene.width || y >= scene.height) continue;
    float* to =
        maps + static_cast<std::size_t>(y) * static_cast<std::size_t>(scene.width) + static_cast<std::size_t>(x);
    for (int boundary = 0; boundary <= shadow_shells; ++boundary)
      to[static_cast<std::size_t>(boundary) * texels] = kept.at(boundary, i);
  }
}

void DrawShellShadow(const MarchScene& scene, const Tile& tile, TileScratch& scratch, float* maps) {
  scratch.clear();
  raster_skin(scene, tile, scratch);
  raster_fur(scene, tile, scratch);
  for (int group = 0; group < groups_across * groups_down; ++group) {
    const int left = tile.left + group % groups_across * group_width,
              top = tile.top + group / groups_across * group_height;
    Ray ray = ray_of(scene, left, top);
    ray.offset = 0.5f;  // maps are read between their texels
    KeptLight kept;
    if (scratch.first[static_cast<std::size_t>(group)] != 0) {
      for_each_step(scene, scratch, group, [&](const Segments& segments, const End& near, const End& far) HWY_ATTR {
        stop_light(scene, ray, scratch, segments, near, far, kept);
        return true;
      });
    }
    write_kept(scene, left, top, kept, maps);
  }
}

const char* InstructionSet() { return hwy::TargetName(HWY_TARGET); }

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pelage {

HWY_EXPORT(PlaceShellVertices);
HWY_EXPORT(DrawTile);
HWY_EXPORT(DrawShellShadow);
HWY_EXPORT(InstructionSet);

void place_shell_vertices(MarchScene& scene, std::size_t begin, std::size_t end) {
  HWY_DYNAMIC_DISPATCH(PlaceShellVertices)(scene, begin, end);
}

void draw_tile(const MarchScene& scene, const Tile& tile, TileScratch& scratch, float* light, AovPixel* aovs) {
  HWY_DYNAMIC_DISPATCH(DrawTile)(scene, tile, scratch, light, aovs);
}

void draw_shell_shadow(const MarchScene& scene, const Tile& tile, TileScratch& scratch, float* maps) {
  HWY_DYNAMIC_DISPATCH(DrawShellShadow)(scene, tile, scratch, maps);
}

const char* instruction_set() { return HWY_DYNAMIC_DISPATCH(InstructionSet)(); }

}  // namespace pelage
#endif
