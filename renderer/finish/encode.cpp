#include "renderer/finish/encode.h"

#include <cmath>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "renderer/finish/encode.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep

#include "renderer/optics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

using std::floor;  // for values that are the same in all lanes

/// The encoding of a picture, under the name that the shared code uses.
struct Encoder {
  const Encoding& encoding;

#define FUNCTION HWY_INLINE
#include "renderer/shaders/shared/encode.glsl"
#undef FUNCTION
};

HWY_INLINE Int number_of(const Encoding& encoding, Real share) {
  const Int number = to_int(share * static_cast<float>(encoding.largest) + 0.5f);
  return hn::Min(hn::Max(number, splat(0)), splat(encoding.largest));
}

HWY_INLINE void encode(const Encoding& encoding, Real x, float y, const float* light, const float* overlay,
                       std::int32_t* numbers) {
  hn::Vec<FloatTag> r, g, b, a;
  hn::LoadInterleaved4(float_tag, light, r, g, b, a);
  Encoder encoder{encoding};
  const Vec4 encoded = encoder.encoded(x, y, Vec3(r, g, b), a);
  Vec3 colour(encoded.x, encoded.y, encoded.z);
  Real opacity = encoded.w;
  if (overlay) {
    hn::LoadInterleaved4(float_tag, overlay, r, g, b, a);
    colour = mix(colour, Vec3(r, g, b), Real(a));
    opacity = select(Real(a) >= 1.0f, 1.0f, opacity);
  }
  hn::StoreInterleaved4(number_of(encoding, colour.x), number_of(encoding, colour.y), number_of(encoding, colour.z),
                        number_of(encoding, opacity), int_tag, numbers);
}

void EncodeRow(const Encoding& encoding, int row, const float* light, const float* overlay, std::int32_t* numbers) {
  static_assert(encode_batch % lane_count == 0);
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
