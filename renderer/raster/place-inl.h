// Strands on the picture, eight at once.
#if defined(PELAGE_RASTER_PLACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_PLACE_INL_H_
#undef PELAGE_RASTER_PLACE_INL_H_
#else
#define PELAGE_RASTER_PLACE_INL_H_
#endif

#include "renderer/optics/lanes-inl.h"
#include "renderer/raster/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

inline constexpr int most_knots = 64;
inline constexpr float min_segment = 2;  // pixels: knots nearer than that are left out

/// Knots of as many strands as there are lanes.
struct KnotLanes {
  HWY_ALIGN float x[most_knots][lane_count], y[most_knots][lane_count];
  HWY_ALIGN float inverse[most_knots][lane_count], half_width[most_knots][lane_count];
};

HWY_INLINE Int strand_rows(const std::uint32_t* ids, int numbers) {
  return hn::Mul(hn::LoadU(int_tag, reinterpret_cast<const std::int32_t*>(ids)), whole(numbers));
}

/// Where lanes lie on the picture.
struct PlacedLanes {
  Real left, right, top, bottom;
  Real nearest;  // one over a distance
  Real way;      // pixels along the strand
};

HWY_INLINE PlacedLanes place_lanes(const PictureCamera& camera, const StrandSet& set, const std::uint32_t* ids,
                                   const float* widened, KnotLanes& knots) {
  const Int rows = strand_rows(ids, (set.segments + 1) * 4);
  const Real wider = load(widened) * camera.scale;
  const Real far = 1e30f, none = 0.0f;
  PlacedLanes placed{far, -far, far, -far, none, none};
  Real before_x = 0.0f, before_y = 0.0f;
  for (int k = 0; k <= set.segments; ++k) {
    const Quad point = gather_quad(&set.points[0].place.x + 4 * k, rows);
    const Vec3 apart = Vec3(point.real(0), point.real(1), point.real(2)) - Vec3(camera.position);
    const Real distance = dot(apart, Vec3(camera.forward));
    const Mask seen = distance > nearest_drawn;
    const Real inverse = 1.0f / max(distance, nearest_drawn), scale = inverse * camera.scale;
    const Real x = mul_add(dot(apart, Vec3(camera.right)), scale, camera.middle.x);
    const Real y = Real(camera.middle.y) - dot(apart, Vec3(camera.up)) * scale;
    const Real half = point.real(3) * inverse * wider;
    store(x, knots.x[k]), store(y, knots.y[k]), store(half, knots.half_width[k]);
    store(select(seen, inverse, 0.0f), knots.inverse[k]);
    if (k > 0) placed.way += length(Vec2{x - before_x, y - before_y});
    before_x = x, before_y = y;
    placed.left = select(seen, min(placed.left, x - half), placed.left);
    placed.right = select(seen, max(placed.right, x + half), placed.right);
    placed.top = select(seen, min(placed.top, y - half), placed.top);
    placed.bottom = select(seen, max(placed.bottom, y + half), placed.bottom);
    placed.nearest = select(seen, max(placed.nearest, inverse), placed.nearest);
  }
  return placed;
}

/// Whether lanes touch the box, and are not behind what lies in the one tile that they are in.
HWY_INLINE Mask seen_lanes(const PlacedLanes& placed, const RasterBox& box, std::span<const float> furthest) {
  const auto left = static_cast<float>(box.left), top = static_cast<float>(box.top);
  const auto right = static_cast<float>(box.right), bottom = static_cast<float>(box.bottom);
  const Mask inside = (placed.right > left) & (placed.left < right) & (placed.bottom > top) & (placed.top < bottom);
  const int across = (box.right - box.left + tile_side - 1) / tile_side;
  const auto tile_of = [](Real pixel, float first, float end) HWY_ATTR {
    return floor((clamp(pixel, first, end - 1.0f) - first) * (1.0f / tile_side));
  };
  const Real x0 = tile_of(placed.left, left, right), x1 = tile_of(placed.right, left, right);
  const Real y0 = tile_of(placed.top, top, bottom), y1 = tile_of(placed.bottom, top, bottom);
  const Int tile = to_int(mul_add(y0, static_cast<float>(across), x0));
  const Mask in_one = (x0 >= x1) & (y0 >= y1);
  return inside & ((placed.nearest > gather(furthest.data(), tile)) | !in_one);
}

/// Appends the knots of a lane that are more than a few pixels apart.
HWY_INLINE void append_lane(const KnotLanes& knots, int lane, int segments, float way, PlacedStrands& placed) {
  const float wanted = way / min_segment;
  const int count = wanted >= static_cast<float>(segments) ? segments : std::max(1, static_cast<int>(wanted));
  for (int i = 0; i <= count; ++i) {
    const int k = i * segments / count;
    placed.knots.push_back({knots.x[k][lane], knots.y[k][lane], knots.inverse[k][lane], knots.half_width[k][lane], {}});
  }
  placed.first.push_back(static_cast<std::uint32_t>(placed.knots.size()));
}

HWY_INLINE void place_all(const RasterScene& scene, const StrandSet& set, const RasterBox& box,
                          std::span<const float> furthest, KeptStrands& kept, PlacedStrands& placed) {
  KnotLanes knots;
  const std::size_t count = kept.ids.size();
  std::size_t stay = 0;
  if (placed.first.empty()) placed.first.push_back(0);
  for (std::size_t i = 0; i < count; i += lane_count) {
    std::uint32_t ids[lane_count];
    float widened[lane_count], way[lane_count];
    for (std::size_t l = 0; l < lane_count; ++l) {
      const std::size_t at = std::min(i + l, count - 1);
      ids[l] = kept.ids[at], widened[l] = kept.widened[at];
    }
    const PlacedLanes lanes = place_lanes(scene.camera, set, ids, widened, knots);
    store(lanes.way, way);
    std::uint32_t seen = bits_of(seen_lanes(lanes, box, furthest));
    if (count - i < lane_count) seen &= (1u << (count - i)) - 1;
    for (; seen != 0; seen &= seen - 1) {
      const int lane = std::countr_zero(seen);
      kept.ids[stay] = ids[lane], kept.widened[stay] = widened[lane], ++stay;
      append_lane(knots, lane, set.segments, way[lane], placed);
    }
  }
  kept.ids.resize(stay), kept.widened.resize(stay);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
