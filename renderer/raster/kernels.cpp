#include "renderer/raster/kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/raster/kernels.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep

#include "renderer/raster/blend-inl.h"
#include "renderer/raster/cell_rows-inl.h"
#include "renderer/raster/eyes-inl.h"
#include "renderer/raster/ground-inl.h"
#include "renderer/raster/place-inl.h"
#include "renderer/raster/shared_light-inl.h"
#include "renderer/raster/skin_light-inl.h"
#include "renderer/raster/strand_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

void HandOnLight(const StrandSet& set, const LightSources& sources, std::size_t first, PlacedStrands& placed) {
  if (sources.from_root.by_colour)
    hand_on_all<true>(set, sources, first, placed);
  else
    hand_on_all<false>(set, sources, first, placed);
}

void BlendSegments(const RasterScene& scene, std::span<const TileSegment> segments, int left, int top, TileSums& sums) {
  switch (scene.output) {
    case RasterOutput::distance: return blend_all<RasterOutput::distance>(segments, left, top, sums);
    case RasterOutput::depth: return blend_all<RasterOutput::depth>(segments, left, top, sums);
    case RasterOutput::strand: return blend_all<RasterOutput::strand>(segments, left, top, sums);
    case RasterOutput::count: return blend_all<RasterOutput::count>(segments, left, top, sums);
    default: return blend_all<RasterOutput::albedo>(segments, left, top, sums);
  }
}

void LightSkin(const RasterScene& scene, SkinSeen& seen) {
  for (int i = 0; i < SkinSeen::count; i += lane_count) light_seen(scene, seen, i);
}

CellRange RoundCells(const float* sums, bool quantize, std::span<Crossed> cells) {
  return quantize ? round_row<true>(sums, cells) : round_row<false>(sums, cells);
}

const char* Name() { return hwy::TargetName(HWY_TARGET); }

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pelage {

HWY_EXPORT(place_all);
HWY_EXPORT(find_all_changed);
HWY_EXPORT(light_all);
HWY_EXPORT(HandOnLight);
HWY_EXPORT(BlendSegments);
HWY_EXPORT(intersect_all);
HWY_EXPORT(light_eyes_of);
HWY_EXPORT(LightSkin);
HWY_EXPORT(darken_all);
HWY_EXPORT(add_row);
HWY_EXPORT(RoundCells);
HWY_EXPORT(Name);

void place_strands(const RasterScene& scene, const GrownPart& part, const PixelBox& box, std::span<const float> hidden,
                   KeptStrands& kept, PlacedStrands& placed) {
  HWY_DYNAMIC_DISPATCH(place_all)(scene, part, box, hidden, kept, placed);
}

void find_changed(const RasterScene& scene, const GrownPart& part, const KeptStrands& kept,
                  std::span<const std::int32_t> blocks, std::vector<StrandBox>& boxes) {
  HWY_DYNAMIC_DISPATCH(find_all_changed)(scene, part, kept, blocks, boxes);
}

void light_strands(const RasterScene& scene, const GrownPart& part, std::span<const std::uint32_t> ids, bool from_root,
                   LitPoints& light) {
  HWY_DYNAMIC_DISPATCH(light_all)(scene, part, ids, from_root, light);
}

void distribute_light(const StrandSet& set, const LightSources& sources, std::size_t first, PlacedStrands& placed) {
  HWY_DYNAMIC_DISPATCH(HandOnLight)(set, sources, first, placed);
}

void blend_segments(const RasterScene& scene, std::span<const TileSegment> segments, int left, int top,
                    TileSums& sums) {
  HWY_DYNAMIC_DISPATCH(BlendSegments)(scene, segments, left, top, sums);
}

void intersect_eyes(const RasterScene& scene, int left, int top, std::span<float> background_inverse,
                    std::span<std::int8_t> numbers) {
  HWY_DYNAMIC_DISPATCH(intersect_all)(scene, left, top, background_inverse.data(), numbers.data());
}

void light_eyes(const RasterScene& scene, int left, int top, std::span<const std::int8_t> numbers,
                std::span<const float> background_inverse, TileSums& sums) {
  HWY_DYNAMIC_DISPATCH(light_eyes_of)(scene, left, top, numbers.data(), background_inverse.data(), sums);
}

void light_skin(const RasterScene& scene, SkinSeen& seen) { HWY_DYNAMIC_DISPATCH(LightSkin)(scene, seen); }

void darken_ground(const RasterScene& scene, int left, int top, std::span<float> transmittance) {
  HWY_DYNAMIC_DISPATCH(darken_all)(scene, left, top, transmittance);
}

void add_cells(std::span<const Crossed> cells, float share, float* sums) {
  HWY_DYNAMIC_DISPATCH(add_row)(cells, share, sums);
}

CellRange round_cells(const float* sums, bool quantize, std::span<Crossed> cells) {
  return HWY_DYNAMIC_DISPATCH(RoundCells)(sums, quantize, cells);
}

const char* instruction_set() { return HWY_DYNAMIC_DISPATCH(Name)(); }

}  // namespace pelage
#endif
