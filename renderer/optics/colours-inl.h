// Reads colours from packed words and images.
#if defined(PELAGE_OPTICS_COLOURS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_COLOURS_INL_H_
#undef PELAGE_OPTICS_COLOURS_INL_H_
#else
#define PELAGE_OPTICS_COLOURS_INL_H_
#endif

#include <algorithm>

#include "renderer/optics/base_images.h"
#include "renderer/optics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Returns the four bytes of a word, each in [0, 1].
HWY_INLINE Vec4 texel_of(Int word) { return {byte_of<0>(word), byte_of<1>(word), byte_of<2>(word), byte_of<3>(word)}; }

/// Wraps a texel index that lies at most one side length outside of a periodic side.
HWY_INLINE Int wrapped(Int at, Int side) {
  const Int low = hn::IfThenElse(hn::Lt(at, splat(0)), hn::Add(at, side), at);
  return hn::IfThenElse(hn::Lt(low, side), low, hn::Sub(low, side));
}

/// Returns the linear colour of an image at `uv` (v up), bilinear in the mip level nearest to `pixel`, the share of the
/// picture's side that a pixel covers.
HWY_INLINE Vec3 image_colour(const BaseImages& images, Vec3 uv, Real pixel) {
  const auto* numbers = reinterpret_cast<const std::int32_t*>(images.levels.data());
  const auto largest = static_cast<float>(std::max(images.levels[0].width, images.levels[0].height));
  const Real lod = clamp(log2(pixel * largest) + 0.5f, 0.0f, static_cast<float>(images.levels.size()) - 1.0f);
  const Int level = hn::Mul(to_int(lod), splat(3));
  const Int width = gather(numbers, level), height = gather(numbers + 1, level), first = gather(numbers + 2, level);
  const Real u = uv.x - floor(uv.x), v = 1.0f - uv.y - floor(1.0f - uv.y);
  const Real x = u * to_real(width) - 0.5f, y = v * to_real(height) - 0.5f, px = x - floor(x), py = y - floor(y);
  const Int start = hn::Add(first, hn::Mul(hn::Mul(width, height), to_int(max(uv.z, 0.0f) + 0.5f)));
  Vec3 sum(0.0f);
  for (int k = 0; k < 4; ++k) {
    const Int at_x = wrapped(hn::Add(to_int(floor(x)), splat(k & 1)), width),
              at_y = wrapped(hn::Add(to_int(floor(y)), splat(k >> 1)), height);
    const Int word = gather(images.texels.data(), hn::Add(start, hn::Add(hn::Mul(at_y, width), at_x)));
    const auto channel = [&](Int byte) HWY_ATTR { return gather(images.linear.data(), hn::And(byte, splat(255))); };
    const Real weight = (k & 1 ? px : 1.0f - px) * (k & 2 ? py : 1.0f - py);
    sum += weight * Vec3(channel(word), channel(hn::ShiftRight<8>(word)), channel(hn::ShiftRight<16>(word)));
  }
  return select(uv.z < -0.5f, Vec3(1.0f), sum);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
