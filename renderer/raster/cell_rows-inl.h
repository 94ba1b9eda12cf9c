// Adds up and rounds rows of a grid's cells, several numbers at once.
#if defined(PELAGE_RASTER_CELL_ROWS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_CELL_ROWS_INL_H_
#undef PELAGE_RASTER_CELL_ROWS_INL_H_
#else
#define PELAGE_RASTER_CELL_ROWS_INL_H_
#endif

#include <algorithm>

#include "renderer/optics/lanes-inl.h"
#include "renderer/raster/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

using CellNumbers = hn::Rebind<std::uint16_t, FloatTag>;

HWY_INLINE void add_row(std::span<const Crossed> cells, float share, float* sums) {
  const std::uint16_t* from = &cells.data()->strands;
  const std::size_t count = 2 * cells.size();
  std::size_t i = 0;
  for (; i + lane_count <= count; i += lane_count) {
    const Real numbers = to_real(hn::PromoteTo(int_tag, hn::LoadU(CellNumbers(), from + i)));
    store(mul_add(numbers, share, load(sums + i)), sums + i);
  }
  const hn::CappedTag<float, 1> one;  // fused multiply-add, which rounds as in the lanes above
  for (; i < count; ++i)
    hn::StoreU(hn::MulAdd(hn::Set(one, static_cast<float>(from[i])), hn::Set(one, share), hn::LoadU(one, sums + i)),
               one, sums + i);
}

/// Lanes alternate between strands and body. Returns the mask of the body's lanes.
HWY_INLINE Mask odd_lanes() {
  return {hn::MaskFromVec(hn::BitCast(float_tag, hn::Neg(hn::And(hn::Iota(int_tag, 0), splat(1)))))};
}

/// Rounds each number to 6 bits, but to steps of at least 1/64 strand. Such steps are too small to be seen.
HWY_INLINE Real coarse(Real number) {
  constexpr float step = Crossed::one / 64, bits_kept_from = Crossed::one;
  const Int bits = hn::Add(hn::BitCast(int_tag, number.v), splat(1 << 16));
  const Real rounded = hn::BitCast(float_tag, hn::And(bits, splat(~0x1ffff)));
  return select(number < bits_kept_from, floor(number * (1 / step) + 0.5f) * step, rounded);
}

/// Rounds a number to the value that lookups read: in coarse steps, or the maximum behind a body that stops all light.
/// `odd`: the lanes of the body.
HWY_INLINE Real quantized_value(Real number, Mask odd) {
  const Real body = hn::OddEven(number.v, hn::Reverse2(float_tag, number.v));  // in both lanes of its cell
  const Real max_value = select(odd, static_cast<float>(Crossed::max_body), static_cast<float>(Crossed::max_strands));
  return select(body > Crossed::one * opaque_body_depth, max_value, coarse(number));
}

template <bool quantize>
HWY_INLINE CellRange round_row(const float* sums, std::span<Crossed> cells) {
  std::uint16_t* to = &cells.data()->strands;
  const std::size_t count = 2 * cells.size();
  const Mask odd = odd_lanes();
  const Real limits = select(odd, static_cast<float>(Crossed::max_body), static_cast<float>(Crossed::max_strands));
  CellRange changed;
  for (std::size_t i = 0; i < count; i += lane_count) {
    const std::size_t there = std::min<std::size_t>(lane_count, count - i);
    HWY_ALIGN float numbers[lane_count] = {};
    HWY_ALIGN std::uint16_t before[lane_count] = {};
    std::copy_n(sums + i, there, numbers), std::copy_n(to + i, there, before);
    Real sum = load(numbers);
    if constexpr (quantize) sum = quantized_value(sum, odd);
    const Int now = to_int(min(sum + 0.5f, limits));
    if (hn::AllTrue(int_tag, hn::Eq(now, hn::PromoteTo(int_tag, hn::Load(CellNumbers(), before))))) continue;
    hn::Store(hn::DemoteTo(CellNumbers(), now), CellNumbers(), before);
    std::copy_n(before, there, to + i);
    changed.add({static_cast<int>(i / 2), static_cast<int>((i + there) / 2)});
  }
  return changed;
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
