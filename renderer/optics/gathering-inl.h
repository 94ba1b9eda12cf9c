// Strands that gather towards a middle: tufts on the surface and clumps on the tile. The twin of
// renderer/shaders/tufts.glsl and of the clumps of paint_form.glsl.
#if defined(PELAGE_OPTICS_GATHERING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_GATHERING_INL_H_
#undef PELAGE_OPTICS_GATHERING_INL_H_
#else
#define PELAGE_OPTICS_GATHERING_INL_H_
#endif

#include "renderer/optics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Where the strands of a place gather.
struct Gathering {
  Vec2 middle;  // from here, tiles
  Real inside;  // 0 on the border to the next, 1 in the middle
  Real gather;  // part of the way at the tip; 0 for none
};

HWY_INLINE Gathering no_gathering() { return {{0.0f, 0.0f}, 1.0f, 0.0f}; }

/// At a height: the way from here to the root of the strand that is here, and the optical depth over that of fur that
/// does not gather. The strand grows further out, and past the border there is none.
struct Gathered {
  Vec2 shift;  // tiles
  Real depth;
};

HWY_INLINE Gathered gathered_at(const Gathering& of, Real s) {
  const Real part = of.gather * s * sqrt(s), over = 1.0f / (1.0f - part);
  return {of.middle * (-part * over), clamp(1.0f + (of.inside - part) * (1 / 0.15f), 0.0f, 1.0f) * over};
}

/// How strands lean to the middle at a height, tiles for a unit of height.
HWY_INLINE Vec2 lean_to_middle(const Gathering& of, Real s) {
  const Real root = sqrt(s);
  return of.middle * (1.5f * of.gather * root / (1.0f - of.gather * s * root));
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
