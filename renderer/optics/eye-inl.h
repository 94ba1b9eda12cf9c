// Eyes for several pixels at once: compiles renderer/shaders/shared, which is also GLSL, for SIMD lanes.
#if defined(PELAGE_OPTICS_EYE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_EYE_INL_H_
#undef PELAGE_OPTICS_EYE_INL_H_
#else
#define PELAGE_OPTICS_EYE_INL_H_
#endif

#include <cmath>

#include "renderer/eye/optics.h"
#include "renderer/optics/colours-inl.h"
#include "renderer/optics/light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

using std::asin, std::sin;  // for values that are the same in all lanes

/// Reads a level bilinearly at a position in [0, 1]^2; texels are four bytes; `around` wraps, `along` is clamped.
HWY_INLINE Vec4 level_texel(const TissueLevels& tissues, Int level, Real around, Real along) {
  const Int width = hn::Shr(splat(iris_map_width), level), height = hn::Shr(splat(iris_map_height), level);
  const Int first = gather(tissues.first.data(), level), last_row = hn::Sub(height, splat(1));
  const Real x = around * to_real(width) - 0.5f, y = clamp(along * to_real(height) - 0.5f, 0.0f, to_real(last_row));
  const Real left = floor(x), top = floor(y), px = x - left, py = y - top;
  Vec4 sum(0.0f, 0.0f, 0.0f, 0.0f);
  for (int k = 0; k < 4; ++k) {
    const Int column = hn::And(hn::Add(to_int(left), splat(k & 1)), hn::Sub(width, splat(1)));
    const Int row = hn::Min(hn::Add(to_int(top), splat(k >> 1)), last_row);
    const Real weight = (k & 1 ? px : 1.0f - px) * (k & 2 ? py : 1.0f - py);
    sum += weight * texel_of(gather(tissues.words.data(), hn::Add(first, hn::Add(hn::Mul(row, width), column))));
  }
  return sum;
}

/// An eye of a frame and the light on it, under the names that the shared code uses.
struct EyeShading : FrameLight {
  const EyeEntry& eye;
  const glm::vec3& eye_viewer;
  const glm::vec4& surroundings;
  const TissueLevels& tissues;
  const float* caustics;
  int eye_lights;  // number of the frame's lights
  int eye_steps;

  /// `optics` and `camera` must outlive this; `camera` is in the frame of that eye.
  HWY_INLINE EyeShading(const FrameOptics& optics, const EyeCamera& camera, std::size_t number)
      : FrameLight(optics),
        eye(optics.eyes.block.eyes[number]),
        eye_viewer(camera.viewer),
        surroundings(optics.eyes.block.surroundings),
        tissues(*optics.eyes.tissues),
        caustics(optics.eyes.caustics.data()),
        eye_lights(optics.lights),
        eye_steps(optics.eyes.steps) {}

  HWY_INLINE Vec4 tissue_of_level(Real level, Real around, Real along) const {
    return level_texel(tissues, to_int(level), around, along);
  }
  /// Returns the caustic `beside` texels after a texel, which is an integer.
  HWY_INLINE Real caustic_at(Real texel, int beside) const { return gather(caustics + beside, to_int(texel)); }

#define FUNCTION HWY_INLINE
#define In(type) const type&
#include "renderer/shaders/shared/iris.glsl"
// eye.glsl uses names of iris.glsl, so it comes second:
#include "renderer/shaders/shared/eye.glsl"
#undef In
#undef FUNCTION
};

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
