// AOVs of marched frames beside those of the GL.
#include <algorithm>
#include <array>
#include <cmath>

#include "tests/gl/marched_frames.h"
#include "tests/gl/with_renderer.h"

namespace pelage::testing::marched_aovs_test {
namespace {

constexpr std::array all{Aov::beauty, Aov::depth,  Aov::position, Aov::normal,     Aov::tangent,
                         Aov::albedo, Aov::direct, Aov::shadow,   Aov::shell_count};
using Aovs = std::vector<FloatImage>;

glm::dvec3 pixel(const Aovs& aovs, Aov aov, std::size_t i) {
  const auto at = static_cast<std::size_t>(std::find(all.begin(), all.end(), aov) - all.begin());
  return {aovs[at].rgba[4 * i], aovs[at].rgba[4 * i + 1], aovs[at].rgba[4 * i + 2]};
}

double alpha(const Aovs& aovs, std::size_t i) { return aovs[0].rgba[4 * i + 3]; }

class MarchedAovs : public WithRenderer {
 protected:
  struct Pair {
    Aovs marched, by_gl;
  };
  Pair both(const FurredModel& model, const FrameRequest& request) {
    draw(*renderer, model, request);
    const FurFrame frame = make_frame(model.view(), request);
    MarchedRenderer marched(2);
    const ModelArrays arrays = make_arrays(model.view());
    marched.add(make_model(model.view(), arrays), make_fields(model.view(), frame.skin, {}));
    return {marched.draw_aovs(frame, all, nullptr, {}).value(), renderer->draw_aovs(frame, all).value()};
  }
  static FrameRequest of_shells(int shells) {
    FrameRequest request = small_frame(AutoView::three_quarter, 128);
    request.knobs.shells = shells;
    return request;
  }
};

/// Mean over pixels that both cover of how far two AOVs lie apart.
double apart(const Aovs& a, const Aovs& b, Aov aov) {
  double sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < a[0].rgba.size() / 4; ++i) {
    if (alpha(a, i) < 0.98 || alpha(b, i) < 0.98) continue;
    sum += glm::length(pixel(a, aov, i) - pixel(b, aov, i)), ++count;
  }
  return count > 100 ? sum / count : 1e9;
}

// Bounds are about one and a half times what was seen; another AOV in its place would lie .2 and more apart. Segments
// are fewer than shells' fragments.
TEST_P(MarchedAovs, AreThoseOfTheGl) {
  struct Bound {
    Aov aov;
    double furred, bare;
  };
  for (const double length : {0.04, 0.0}) {
    FurredModel model = furred({Builtin::creature, 3000}, {.length = length, .inclination = 0.4});
    model.settings.eyes = {{.position = {0, 0.2, 0.6}, .radius = 0.1}};
    const Pair pair = both(model, of_shells(32));
    for (const Bound& bound :
         {Bound{Aov::beauty, 0.04, 0.002}, Bound{Aov::depth, 8e-4, 1e-6}, Bound{Aov::position, 0.002, 1e-6},
          Bound{Aov::normal, 0.032, 1e-5}, Bound{Aov::tangent, 0.042, 1e-5}, Bound{Aov::albedo, 0.02, 0.001},
          Bound{Aov::direct, 0.026, 0.002}, Bound{Aov::shadow, 0.054, 1e-6}}) {
      EXPECT_LT(apart(pair.marched, pair.by_gl, bound.aov), length > 0 ? bound.furred : bound.bare) << int(bound.aov);
    }
  }
}

// What stands on the body and around it is in them too; the ground is in light alone.
TEST_F(MarchedFrames, HaveAovsOfAllThatStandsOnTheBody) {
  const FurredModel model = animal();
  const FurFrame frame = frame_of(model);
  const Aovs aovs = marched.draw_aovs(frame, all, nullptr, {}).value();
  int ground = 0;
  for (std::size_t i = 0; i < aovs[0].rgba.size() / 4; ++i) {
    const bool there = aovs[1].rgba[4 * i] > 0;
    const double cover = aovs[2].rgba[4 * i + 3];
    ASSERT_LE(cover, alpha(aovs, i) + 1e-4) << i;
    ASSERT_TRUE(std::abs(cover - 0.5) < 0.05 || there == (cover > 0.5)) << i;
    ground += alpha(aovs, i) > 0.05 && cover == 0;
    const double light = glm::length(pixel(aovs, Aov::direct, i) - pixel(aovs, Aov::beauty, i));
    ASSERT_TRUE(std::isfinite(light));
    for (int k = 0; k < 3; ++k) ASSERT_LE(pixel(aovs, Aov::direct, i)[k], pixel(aovs, Aov::beauty, i)[k] + 1e-4) << i;
    ASSERT_TRUE(cover < 0.9 || std::abs(glm::length(pixel(aovs, Aov::normal, i)) - 1) < 1e-4) << i;
  }
  EXPECT_GT(ground, 100);
}

INSTANTIATE_TEST_SUITE_P(Backends, MarchedAovs, ::testing::Values(Backend::egl_device), name_of);

}  // namespace
}  // namespace pelage::testing::marched_aovs_test
