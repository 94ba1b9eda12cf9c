// Light on fur and skin for several pixels at once: compiles renderer/shaders/shared, which is also GLSL, for SIMD
// lanes.
#if defined(PELAGE_OPTICS_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_LIGHT_INL_H_
#undef PELAGE_OPTICS_LIGHT_INL_H_
#else
#define PELAGE_OPTICS_LIGHT_INL_H_
#endif

#include "renderer/optics/frame_optics.h"
#include "renderer/optics/lanes-inl.h"
#include "renderer/optics/scattering-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Returns the colour of the fur above a height over the colour there.
HWY_INLINE Vec3 colour_above(const FrameBlock& frame, Real height) {
  const Int slice = to_int(clamp(height * static_cast<float>(slice_count), 0.0f, slice_count - 1.0f));
  const Quad colour = gather_quad(&frame.colour_above[0].x, hn::ShiftLeft<2>(slice));
  return {colour.real(0), colour.real(1), colour.real(2)};
}

/// Returns a random point in [0, 1]^3 for an integer cell: pcg3d (Jarzynski and Olano 2020).
HWY_INLINE Vec3 point_in_cell(Vec3 cell) {
  Int x = to_int(cell.x), y = to_int(cell.y), z = to_int(cell.z);
  const auto seeded = [](Int v) HWY_ATTR { return hn::Add(hn::Mul(v, splat(1664525)), splat(1013904223)); };
  const auto mixed = [](Int v, Int a, Int b) HWY_ATTR { return hn::Add(v, hn::Mul(a, b)); };
  const auto folded = [](Int v) HWY_ATTR {
    const hn::RebindToUnsigned<IntTag> bits;
    return hn::Xor(v, hn::BitCast(int_tag, hn::ShiftRight<16>(hn::BitCast(bits, v))));
  };
  x = seeded(x), y = seeded(y), z = seeded(z);
  x = mixed(x, y, z), y = mixed(y, z, x), z = mixed(z, x, y);
  x = folded(x), y = folded(y), z = folded(z);
  x = mixed(x, y, z), y = mixed(y, z, x), z = mixed(z, x, y);
  const auto share = [](Int v) HWY_ATTR {
    const hn::RebindToUnsigned<IntTag> bits;
    return to_real(hn::BitCast(int_tag, hn::ShiftRight<8>(hn::BitCast(bits, v)))) * (1.0f / 16777216);
  };
  return {share(x), share(y), share(z)};
}

#define FUNCTION HWY_INLINE
#include "renderer/shaders/shared/skin.glsl"
#undef FUNCTION

/// The blocks of a frame, under the names that the shared code uses. Its functions change nothing, but they are not
/// const, because GLSL has no such keyword; so objects cannot be const either.
struct FrameLight {
  const FrameBlock& frame;
  const SkinBlock& bare_skin;
  bool directional_lights;
  static constexpr bool white_surroundings = false;

  explicit FrameLight(const FrameOptics& optics)
      : frame(optics.frame), bare_skin(optics.skin), directional_lights(optics.directional_lights) {}

#define FUNCTION HWY_INLINE
#include "renderer/shaders/shared/bare_skin.glsl"
#include "renderer/shaders/shared/light.glsl"
#undef FUNCTION
};

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
