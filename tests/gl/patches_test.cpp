// Overlapping triangles of patches together transmit what a single one would.
#include <algorithm>

#include "server/frames/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::patches_test {
namespace {

class SharedFur : public WithRenderer {};

/// Draws the model with each triangle once for every weight.
Image draw_with_weights(Renderer& renderer, const FurredModel& model, const std::vector<float>& weights) {
  const Mesh& mesh = model.model.surface.mesh();
  const FurTriangles whole = make_fur_triangles(mesh, with_hard_borders(model.model.patches));
  FurTriangles patch_triangles;
  for (const float weight : weights) {
    patch_triangles.triangles.insert(patch_triangles.triangles.end(), whole.triangles.begin(), whole.triangles.end());
    for (std::array<FurCorner, 3> corners : whole.corners) {
      for (FurCorner& corner : corners) corner.weight = weight;
      patch_triangles.corners.push_back(corners);
    }
  }
  FurFrame frame = make_frame(model.view(), shells_frame(AutoView::three_quarter, 192));
  static std::uint64_t last_id = 1'000'000;  // far from the ids of other models
  frame.model = ++last_id;
  const FurModel fur{frame.model,
                     mesh.positions,
                     mesh.normals,
                     mesh.tangents,
                     patch_triangles.triangles,
                     patch_triangles.corners,
                     {},
                     !mesh.corners.empty()};
  renderer.add_shells(fur, FurFields{model.fields.direction(), model.fields.length(), {}});
  return renderer.draw(frame).value();
}

TEST_P(SharedFur, PatchTrianglesWithSharesMakeOneFur) {
  const FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0.06, .inclination = 0.4});
  const auto with = [&](const std::vector<float>& weights) { return draw_with_weights(*renderer, model, weights); };
  const Image one = with({1}), shared = with({0.3f, 0.7f}), twice = with({1, 1}), half = with({0.5f});
  const double difference = mean_difference(shared, one);
  EXPECT_LT(difference, 0.25 * mean_difference(twice, one));
  EXPECT_LT(difference, 0.25 * mean_difference(half, one));
}

/// Soft overlaps show the same fur as hard borders; only which strand is where differs.
TEST_P(SharedFur, OverlapsKeepCoverAndColour) {
  const FurredModel model = furred({Builtin::creature, 3000});
  FurredModel hard = furred({Builtin::creature, 3000});
  hard.model.patches = with_hard_borders(hard.model.patches);
  const FrameRequest request = shells_frame(AutoView::three_quarter, 192);
  const Image soft_image = draw(*renderer, model, request), hard_image = draw(*renderer, hard, request);
  EXPECT_NEAR(covered(soft_image), covered(hard_image), 0.01 * covered(hard_image));
  const glm::dvec3 soft_colour = mean_colour(soft_image), hard_colour = mean_colour(hard_image);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(soft_colour[k], hard_colour[k], 2);
}

INSTANTIATE_TEST_SUITE_P(Gl, SharedFur, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing::patches_test
