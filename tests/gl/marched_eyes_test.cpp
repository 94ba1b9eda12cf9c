// Eyes marched on the CPU beside those of the GL's eye pass.
#include <algorithm>
#include <cmath>

#include "renderer/finish/finish.h"
#include "renderer/marched/marcher.h"
#include "server/frames/fur_view.h"
#include "tests/gl/flip.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::marched_eyes_test {
namespace {

constexpr int size = 160;

FloatImage march(const FurredModel& model, const FurFrame& frame, int threads = 2) {
  Marcher marcher(threads);
  const ModelArrays arrays = make_arrays(model.view());
  marcher.add(make_model(model.view(), arrays), make_fields(model.view(), frame.skin, {}));
  return marcher.draw(frame, {32, 0, 1, 64});
}

/// A sphere of radius .289 with an eye in front of its middle.
FurredModel with_eye(Eye eye, FirstGroom fur = {.length = 0}) {
  FurredModel model = furred({Builtin::sphere, 2000}, fur);
  eye.position = model.model.surface.mesh().to_model({0, 0, 0.25}), eye.radius = 0.12;
  model.settings.eyes = {eye};
  return model;
}

FrameRequest request_of(AutoView view = AutoView::front) {
  FrameRequest request = small_frame(view, size);
  request.knobs.order = FragmentOrder::sorted, request.knobs.shells = 32;
  return request;
}

bool is_light(const FloatImage& image) {
  return std::all_of(image.rgba.begin(), image.rgba.end(), [](float v) { return std::isfinite(v) && v >= 0; });
}

class MarchedEyes : public WithRenderer {
 protected:
  double apart(const FurredModel& model, const FrameRequest& request) {
    const Image drawn = draw(*renderer, model, request);
    const FurFrame frame = make_frame(model.view(), request);
    return flip_between(drawn, finish_picture(frame, {march(model, frame)}));
  }
  double apart(const Eye& eye, int steps = 8) {
    FrameRequest request = request_of();
    request.knobs.eye_steps = steps;
    return apart(with_eye(eye), request);
  }
};

// Of a picture that an eye fills a sixth of; .005 to .01 were seen, most of it the fine tissue of the iris.
TEST_P(MarchedEyes, AnIrisIsThatOfTheShaderInAnyNumberOfSteps) {
  for (const int steps : {0, 1, 2, 8, 32}) {
    EXPECT_LT(apart(Eye{}, steps), 0.012) << steps;
  }
}

TEST_P(MarchedEyes, PupilsCorneasAndWetnessAreThoseOfTheShader) {
  Eye slit, flat, dry, glass;
  slit.pupil = {PupilShape::slit, 0.3};
  flat.bulge = 0, flat.iris.limbal_ring = 1;
  dry.wetness = 0;
  glass.refraction = 3;
  int number = 0;
  for (const Eye& eye : {slit, flat, dry, glass}) EXPECT_LT(apart(eye), 0.013) << number++;
}

TEST_P(MarchedEyes, LidsAreThoseOfTheShader) {
  Eye eye;
  eye.lids = Lids{.width_degrees = 60, .upper_degrees = 25, .lower_degrees = 20, .tilt_degrees = 10};
  EXPECT_LT(apart(eye), 0.008);
}

// From the side, so that skin hides a part of it, and fur stands before it.
TEST_P(MarchedEyes, FurAndSkinHideAnEyeAndItHidesThem) {
  const FurredModel bare = with_eye(Eye{}), furry = with_eye(Eye{}, {.length = 0.06, .inclination = 0.5});
  for (const AutoView view : {AutoView::front, AutoView::three_quarter, AutoView::left}) {
    EXPECT_LT(apart(bare, request_of(view)), 0.012) << static_cast<int>(view);
    EXPECT_LT(apart(furry, request_of(view)), 0.04) << static_cast<int>(view);
  }
}

TEST(MarcherOfEyes, GivesTheSameBitsOnAnyNumberOfThreads) {
  const FurredModel model = with_eye(Eye{}, {.length = 0.03});
  const FurFrame frame = make_frame(model.view(), small_frame(AutoView::three_quarter, 64));
  EXPECT_EQ(march(model, frame, 1).rgba, march(model, frame, 7).rgba);
}

TEST(MarcherOfEyes, ExtremesStayLight) {
  Marcher marcher(2);
  for (const double refraction : {1.0, 3.0}) {
    for (const int steps : {0, 1, 64}) {
      Eye eye;
      eye.refraction = refraction, eye.bulge = steps ? 1 : 0, eye.wetness = steps ? 1 : 0;
      eye.iris.depth = steps ? 0.5 : 0, eye.iris.size = steps ? 0.95 : 0.1;
      eye.pupil = {steps % 2 ? PupilShape::slit : PupilShape::round, steps % 2 ? 0.0 : 1.0};
      if (steps == 64) eye.lids = Lids{.width_degrees = 90, .upper_degrees = 90, .lower_degrees = -80};
      const FurredModel model = with_eye(eye);
      const ModelArrays arrays = make_arrays(model.view());
      FurFrame frame = make_frame(model.view(), small_frame(AutoView::front, 48));
      frame.knobs.eye_steps = steps;
      frame.lights.push_back({.kind = LightKind::point, .position = {0, 0, 0.36f}, .radiance = glm::vec3(1e8f)});
      marcher.add(make_model(model.view(), arrays), make_fields(model.view(), frame.skin, {}));
      for (const float z : {2.f, 0.372f, 0.3f, 0.25f, -1.f}) {  // before it, close by, inside, behind
        frame.camera.position = {0, 0, z};
        EXPECT_TRUE(is_light(marcher.draw(frame, {}))) << refraction << " " << steps << " " << z;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Backends, MarchedEyes, ::testing::Values(Backend::egl_device), name_of);

}  // namespace
}  // namespace pelage::testing::marched_eyes_test
