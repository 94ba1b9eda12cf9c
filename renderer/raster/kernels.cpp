#include "renderer/raster/kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/raster/kernels.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep

#include "renderer/raster/blend-inl.h"
#include "renderer/raster/eyes-inl.h"
#include "renderer/raster/ground-inl.h"
#include "renderer/raster/hand_on-inl.h"
#include "renderer/raster/place-inl.h"
#include "renderer/raster/skin_light-inl.h"
#include "renderer/raster/strand_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

void PlaceStrands(const RasterScene& scene, const GrownPart& part, const PixelBox& box, std::span<const float> hidden,
                  KeptStrands& kept, PlacedStrands& placed) {
  place_all(scene, part, box, hidden, kept, placed);
}

void LightStrands(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids, bool whole,
                  std::span<LitStrandPoints> light) {
  light_all(scene, part, ids, whole, light);
}

void HandOnLight(const StrandSet& set, std::uint32_t id, std::uint32_t from, const LitStrandPoints& light,
                 std::span<const float> along, std::span<PlacedKnot> knots) {
  hand_on(set, id, from, light, along.data(), knots.data(), static_cast<int>(knots.size()));
}

void BlendSegments(const RasterScene& scene, std::span<const TileSegment> segments, int left, int top, TileSums& sums) {
  switch (scene.shown) {
    case RasterOutput::distance: return blend_all<RasterOutput::distance>(scene, segments, left, top, sums);
    case RasterOutput::depth: return blend_all<RasterOutput::depth>(scene, segments, left, top, sums);
    case RasterOutput::count: return blend_all<RasterOutput::count>(scene, segments, left, top, sums);
    default: return blend_all<RasterOutput::light>(scene, segments, left, top, sums);
  }
}

void MeetEyes(const RasterScene& scene, int left, int top, std::span<float> ends, std::span<std::int8_t> numbers) {
  meet_all(scene, left, top, ends.data(), numbers.data());
}

void LightEyes(const RasterScene& scene, int left, int top, std::span<const std::int8_t> numbers,
               std::span<const float> ends, TileSums& sums) {
  light_eyes_of(scene, left, top, numbers.data(), ends.data(), sums);
}

void LightSkin(const RasterScene& scene, SkinSeen& seen) {
  for (int i = 0; i < SkinSeen::count; i += lane_count) light_seen(scene, seen, i);
}

void DarkenGround(const RasterScene& scene, int left, int top, TileSums& sums) { darken_all(scene, left, top, sums); }

const char* Name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pelage {

HWY_EXPORT(PlaceStrands);
HWY_EXPORT(LightStrands);
HWY_EXPORT(HandOnLight);
HWY_EXPORT(BlendSegments);
HWY_EXPORT(MeetEyes);
HWY_EXPORT(LightEyes);
HWY_EXPORT(LightSkin);
HWY_EXPORT(DarkenGround);
HWY_EXPORT(Name);

void place_strands(const RasterScene& scene, const GrownPart& part, const PixelBox& box, std::span<const float> hidden,
                   KeptStrands& kept, PlacedStrands& placed) {
  HWY_DYNAMIC_DISPATCH(PlaceStrands)(scene, part, box, hidden, kept, placed);
}

void light_strands(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids, bool whole,
                   std::span<LitStrandPoints> light) {
  HWY_DYNAMIC_DISPATCH(LightStrands)(scene, part, ids, whole, light);
}

void hand_on_light(const StrandSet& set, std::uint32_t id, std::uint32_t from, const LitStrandPoints& light,
                   std::span<const float> along, std::span<PlacedKnot> knots) {
  HWY_DYNAMIC_DISPATCH(HandOnLight)(set, id, from, light, along, knots);
}

void blend_segments(const RasterScene& scene, std::span<const TileSegment> segments, int left, int top,
                    TileSums& sums) {
  HWY_DYNAMIC_DISPATCH(BlendSegments)(scene, segments, left, top, sums);
}

void meet_eyes(const RasterScene& scene, int left, int top, std::span<float> ends, std::span<std::int8_t> numbers) {
  HWY_DYNAMIC_DISPATCH(MeetEyes)(scene, left, top, ends, numbers);
}

void light_eyes(const RasterScene& scene, int left, int top, std::span<const std::int8_t> numbers,
                std::span<const float> ends, TileSums& sums) {
  HWY_DYNAMIC_DISPATCH(LightEyes)(scene, left, top, numbers, ends, sums);
}

void light_skin(const RasterScene& scene, SkinSeen& seen) { HWY_DYNAMIC_DISPATCH(LightSkin)(scene, seen); }

void darken_ground(const RasterScene& scene, int left, int top, TileSums& sums) {
  HWY_DYNAMIC_DISPATCH(DarkenGround)(scene, left, top, sums);
}

const char* raster_instruction_set() { return HWY_DYNAMIC_DISPATCH(Name)(); }

}  // namespace pelage
#endif
