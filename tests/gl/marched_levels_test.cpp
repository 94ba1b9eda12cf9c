// Of a coat's slices a marched frame bakes the levels that it reads: it has the bits that all levels give.
#include <algorithm>

#include "renderer/marched/marcher.h"
#include "tests/gl/marched_frames.h"

namespace pelage::testing::marched_levels_test {
namespace {

class MarchedLevels : public MarchedFrames {
 protected:
  /// A camera that looks at the ball's middle, of radius 1.
  void look_from(double distance) {
    request.camera = {.automatic = AutoView::none, .position = glm::dvec3(0.3, 0.4, 1), .target = {0, 0, 0}};
    request.camera.position *= distance / glm::length(request.camera.position);
  }

  std::vector<float> drawn_with(Marcher& marcher, const FurFrame& frame, const FurredModel& model) {
    const ModelArrays arrays = make_arrays(model.view());
    const FurModel fur = make_model(model.view(), arrays);
    if (!marcher.has(fur.id)) marcher.add(fur, make_fields(model.view(), frame.skin, {}));
    return marcher.draw(frame, march_quality(frame.knobs)).rgba;
  }
};

TEST_F(MarchedLevels, HaveTheBitsOfAllOfThem) {
  FurredModel model = furred({Builtin::sphere, 1500}, {.length = 0.06, .inclination = 0.4});
  model.settings.coat.count = 1000;
  model.settings.lights = {{.self_shadow_maps = true, .cast_shadow = CastShadow::soft},
                           {.kind = LightKind::point, .position = {0.5, 1.2, 0.9}, .self_shadow_maps = true}};
  int coarse = 0, full = 0;
  for (const double distance : {2.0, 6.0, 14.0}) {
    for (const bool maps : {false, true}) {
      look_from(distance);
      request.width = request.height = 96;
      request.knobs.shadow_maps = maps, request.knobs.shadow_resolution = maps && distance == 14 ? 2048 : 256;
      const FurFrame frame = make_frame(model.view(), request);
      Marcher some(2), all(2);
      all.add(frame.coat, bake_slices(frame.coat));
      EXPECT_TRUE(drawn_with(some, frame, model) == drawn_with(all, frame, model)) << distance << " " << maps;
      ++(some.finest_level(frame) > 0 ? coarse : full);
      EXPECT_TRUE(some.has(frame.coat, slice_levels - 1));
      EXPECT_EQ(some.has(frame.coat, 0), some.finest_level(frame) == 0);
    }
  }
  EXPECT_GE(coarse, 2);
  EXPECT_GE(full, 2);
}

TEST_F(MarchedLevels, AreBakedAnewForACameraThatComesNearer) {
  FurredModel model = furred({Builtin::sphere, 1500}, {.length = 0.06, .inclination = 0.4});
  model.settings.coat.count = 1000;
  Marcher one(2), other(2);
  for (const double distance : {14.0, 1.5, 14.0}) {
    look_from(distance);
    const FurFrame frame = make_frame(model.view(), request);
    const std::vector<float> picture = drawn_with(one, frame, model);
    EXPECT_TRUE(one.has(frame.coat, one.finest_level(frame)));
    other.add(frame.coat, bake_slices(frame.coat));
    EXPECT_TRUE(picture == drawn_with(other, frame, model)) << distance;
  }
  EXPECT_TRUE(one.has(make_frame(model.view(), request).coat, 0));  // and kept
}

}  // namespace
}  // namespace pelage::testing::marched_levels_test
