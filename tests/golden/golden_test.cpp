// A few whole pictures against golden ones. After a wanted change run with PELAGE_UPDATE_GOLDEN=1, look at the new
// pictures and commit them on their own with the reason.

#include "tests/gl/with_renderer.h"
#include "tests/golden/expect_golden.h"
#include "tests/support/golden_scenes.h"

namespace pelage::testing {
namespace {

Image picture_of(Renderer& renderer, const Golden& golden, Method method) {
  GoldenScene scene(golden);
  scene.request.knobs.method = method;
  return draw(renderer, scene.model, scene.request);
}

TEST(Pictures, OfStrandsMatchWhatWasLookedAt) {
  Renderer renderer{{.threads = 2}};
  for (const Golden& golden : goldens())
    expect_golden(picture_of(renderer, golden, Method::raster), golden.name, golden.mean, golden.largest);
}

class Shells : public WithRenderer {};

TEST_P(Shells, MatchWhatWasLookedAt) {
  for (const Golden& golden : goldens())
    expect_golden(picture_of(*renderer, golden, Method::shells), std::string("shells_") + golden.name, golden.mean,
                  golden.largest);
}

INSTANTIATE_TEST_SUITE_P(Golden, Shells, all_contexts(), name_of);

}  // namespace
}  // namespace pelage::testing
