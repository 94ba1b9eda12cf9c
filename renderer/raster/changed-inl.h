// Which strands look another way, and where they lie on the picture, a strand a lane.
#if defined(PELAGE_RASTER_CHANGED_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_CHANGED_INL_H_
#undef PELAGE_RASTER_CHANGED_INL_H_
#else
#define PELAGE_RASTER_CHANGED_INL_H_
#endif

#include "renderer/raster/place-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Whether the block of one of a strand's knots has changed.
HWY_INLINE Mask changed_lanes(const BlockPlace& place, std::span<const std::int32_t> blocks, const StrandSet& set,
                              const std::uint32_t* ids) {
  const Int rows = strand_rows(ids, (set.segments + 1) * 4);
  Real changed = 0.0f;
  for (int k = 0; k <= set.segments; ++k) {
    const Quad point = gather_quad(&set.points[0].place.x + 4 * k, rows);
    const Vec3 at = (Vec3{point.real(0), point.real(1), point.real(2)} - Vec3(place.low)) * (1 / place.side);
    const auto block = [](Real along, int count)
                           HWY_ATTR { return to_int(clamp(along, 0.0f, static_cast<float>(count) - 0.5f)); };
    const Int row = hn::Add(hn::Mul(block(at.z, place.count.z), whole(place.count.y)), block(at.y, place.count.y));
    const Int index = hn::Add(hn::Mul(row, whole(place.count.x)), block(at.x, place.count.x));
    changed = max(changed, to_real(gather(blocks.data(), index)));
  }
  return changed > 0.0f;
}

HWY_INLINE void find_all_changed(const RasterScene& scene, const GrownPart& part, const KeptStrands& kept,
                                 std::span<const std::int32_t> blocks, std::vector<StrandBox>& boxes) {
  const StrandSet& set = *part.strands;
  KnotLanes knots;
  const std::size_t count = kept.ids.size();
  boxes.resize(count);
  for (std::size_t i = 0; i < count; i += lane_count) {
    std::uint32_t ids[lane_count];
    float widened[lane_count];
    for (std::size_t l = 0; l < lane_count; ++l) {
      const std::size_t at = std::min(i + l, count - 1);
      ids[l] = kept.ids[at], widened[l] = kept.widened[at];
    }
    const PlacedLanes lanes = place_lanes(scene.camera, set, ids, widened, knots);
    Mask in_front = load(knots.inverse[0]) > 0.0f;
    for (int k = 1; k <= set.segments; ++k) in_front = in_front & (load(knots.inverse[k]) > 0.0f);
    const Real beside = drawn_edge + static_cast<float>(deep_of) * lanes.widest;
    HWY_ALIGN float left[lane_count], top[lane_count], right[lane_count], bottom[lane_count];
    store(lanes.left - beside, left), store(lanes.top - beside, top);
    store(lanes.right + beside, right), store(lanes.bottom + beside, bottom);
    const std::uint32_t changed = bits_of(changed_lanes(scene.grid->blocks(), blocks, set, ids));
    const std::uint32_t bounded = bits_of(in_front);
    for (std::size_t l = 0; l < lane_count && i + l < count; ++l)
      boxes[i + l] = {left[l], top[l], right[l], bottom[l], (changed >> l & 1) != 0, (bounded >> l & 1) != 0};
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
