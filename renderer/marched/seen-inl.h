// What a group of pixels has seen so far: light, and what AOVs keep beside it.
#if defined(PELAGE_MARCHED_SEEN_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_SEEN_INL_H_
#undef PELAGE_MARCHED_SEEN_INL_H_
#else
#define PELAGE_MARCHED_SEEN_INL_H_
#endif

#include "renderer/marched/march_scene.h"
#include "renderer/optics/light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// What AOVs keep of a group.
class AovSums {
 public:
  /// What shows at a place of each pixel.
  struct Shown {
    Vec3 place, normal, tangent, albedo;
    Direct direct;
    Real segments, inverse;
  };

  /// `weight`: share of the pixel; `before`: what had got through to it.
  void add(const Shown& shown, Real weight, Real before) {
    add(AovRows::position, shown.place, weight), add(AovRows::normal, shown.normal, weight);
    add(AovRows::tangent, shown.tangent, weight), add(AovRows::albedo, shown.albedo, weight);
    add(AovRows::direct, shown.direct.light, weight);
    add(AovRows::kept, shown.direct.kept, weight), add(AovRows::whole, shown.direct.whole, weight);
    add(AovRows::cover, 1.0f, weight);
    float* count = rows_[AovRows::count_of_segments];
    store(load(count) + shown.segments, count);
    float* inverse = rows_[AovRows::inverse];
    store(select((before > 0.5f) & (before - weight <= 0.5f), shown.inverse, load(inverse)), inverse);
  }
  /// The same of one lane.
  void add(int lane, const AovPixel& shown, float weight, float before) {
    for (int row = 0; row < AovRows::count_of_segments; ++row)
      rows_[row][lane] += weight * shown[static_cast<std::size_t>(row)];
    rows_[AovRows::cover][lane] += weight;
    if (before > 0.5f && before - weight <= 0.5f) rows_[AovRows::inverse][lane] = shown[AovRows::inverse];
  }
  float at(int row, int lane) const { return rows_[row][lane]; }

 private:
  void add(int row, const Vec3& value, Real weight) {
    add(row, value.x, weight), add(row + 1, value.y, weight), add(row + 2, value.z, weight);
  }
  void add(int row, Real value, Real weight) {
    store(load(rows_[row]) + select(weight > 0.0f, value * weight, 0.0f), rows_[row]);
  }
  float rows_[AovRows::count][lane_count] = {};
};

/// Light that has come to the eye so far, and what still gets through.
struct Seen {
  Vec3 light;
  Real through;
  AovSums* aovs = nullptr;  // null where none are asked for
};

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
