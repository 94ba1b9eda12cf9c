#include "renderer/finish/encode.h"

#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/finish/encode.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep

#include "renderer/optics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// A shoulder and a toe (Narkowicz 2015, a fit of the ACES curve), scaled so that .18 stays about .18.
HWY_INLINE Real film(Real x) {
  x = min(x, 1e4f) * 0.72f;
  return clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
}

HWY_INLINE Real to_srgb(Real linear) {
  const Real high = 1.055f * pow(max(linear, 0.0031308f), 1 / 2.4f) - 0.055f;
  return select(linear < 0.0031308f, 12.92f * linear, high);
}

/// A sheet of paper, lit from above: darker towards the top and the corners. Linear. `x`, `y`: pixels.
HWY_INLINE Vec3 studio(const Encoding& encoding, Real x, float y) {
  const Real across = x * (1 / static_cast<float>(encoding.width));
  const float down = y / static_cast<float>(encoding.height), down_off = down - 0.55f;
  const Real across_off = (across - 0.5f) * 1.1f;
  const Real square = across_off * across_off + down_off * down_off;
  const Vec3 sheet = mix(Vec3(0.30f, 0.315f, 0.335f), Vec3(0.62f, 0.615f, 0.60f), smoothstep(-0.1f, 1.0f, down));
  return sheet * (1.0f - 0.55f * smoothstep(0.1f, 1.0f, 1.6f * square));
}

HWY_INLINE Real fraction(Real x) { return x - floor(x); }

/// Within half a step of a channel, so that the gradient has no bands: interleaved gradient noise (Jimenez 2014).
HWY_INLINE Real dither(const Encoding& encoding, Real x, float y) {
  const Real noise = fraction(52.9829189f * fraction(floor(x) * 0.06711056f + std::floor(y) * 0.00583715f));
  return (noise - 0.5f) * (0.98f / static_cast<float>(encoding.largest));
}

HWY_INLINE Int number_of(const Encoding& encoding, Real share) {
  const Int number = to_int(share * static_cast<float>(encoding.largest) + 0.5f);
  return hn::Min(hn::Max(number, whole(0)), whole(encoding.largest));
}

HWY_INLINE void encode(const Encoding& encoding, Real x, float y, const float* light, const float* overlay,
                       std::int32_t* numbers) {
  hn::Vec<FloatTag> r, g, b, a;
  hn::LoadInterleaved4(float_tag, light, r, g, b, a);
  const Real alpha = clamp(a, 0.0f, 1.0f);
  const Mask seen = alpha > 0.0f;
  Vec3 colour = Vec3(r, g, b) * (encoding.exposure / select(seen, alpha, 1.0f));
  colour = select(seen, colour, Vec3(0.0f));
  colour = encoding.filmic ? each(colour, [](Real c) HWY_ATTR { return film(c); }) : clamp(colour, 0.0f, 1.0f);
  if (!encoding.transparent)
    colour = mix(encoding.studio ? studio(encoding, x, y) : Vec3(encoding.background), colour, alpha);
  colour = each(colour, [](Real c) HWY_ATTR { return to_srgb(c); });
  if (encoding.studio) colour += Vec3(dither(encoding, x, y) * (1.0f - alpha));
  Real opacity = encoding.transparent ? alpha : Real(1.0f);
  if (overlay) {
    hn::LoadInterleaved4(float_tag, overlay, r, g, b, a);
    colour = mix(colour, Vec3(r, g, b), Real(a));
    opacity = select(Real(a) >= 1.0f, 1.0f, opacity);
  }
  hn::StoreInterleaved4(number_of(encoding, colour.x), number_of(encoding, colour.y), number_of(encoding, colour.z),
                        number_of(encoding, opacity), int_tag, numbers);
}

void EncodeRow(const Encoding& encoding, int row, const float* light, const float* overlay, std::int32_t* numbers) {
  static_assert(encoded_together % lane_count == 0);
  const Real middles = to_real(hn::Iota(int_tag, 0)) + 0.5f;
  const float y = static_cast<float>(row) + 0.5f;
  for (int x = 0; x < encoding.width; x += lane_count)
    encode(encoding, middles + static_cast<float>(x), y, light + std::ptrdiff_t{4} * x,
           overlay ? overlay + std::ptrdiff_t{4} * x : nullptr, numbers + std::ptrdiff_t{4} * x);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace pelage {

HWY_EXPORT(EncodeRow);

void encode_row(const Encoding& encoding, int row, const float* light, const float* overlay, std::int32_t* numbers) {
  HWY_DYNAMIC_DISPATCH(EncodeRow)(encoding, row, light, overlay, numbers);
}

}  // namespace pelage
#endif
