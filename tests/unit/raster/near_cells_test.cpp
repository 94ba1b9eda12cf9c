// Cells of single strands near the camera.
#include "renderer/raster/near_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "renderer/raster/raster_scene.h"
#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

constexpr float cell = 0.008f;

/// A lawn seen from above, from so far away that the picture shows `view` sizes across.
struct LawnBelow {
  FurPatch patch{0.5, 10, 0.03f};
  GrownFur fur;
  RasterScene scene;

  explicit LawnBelow(float view) {
    grow();
    scene.width = scene.height = 100, scene.cells = GridLayout{.cell = cell};
    scene.camera.forward = {0, 0, -1}, scene.camera.up = {0, 1, 0};
    look(view);
  }
  void grow() { fur.update(patch.model(), patch.fields(), GrowRecipe{plain_coat(4000)}, 2), scene.parts = fur.parts(); }
  void look(float view) {
    scene.camera.scale = 200;
    scene.camera.position = {0.25f, 0.25f, view * scene.camera.scale / static_cast<float>(scene.width)};
  }
};

double sum_of(const NearCells& near) {
  return std::accumulate(near.cells().begin(), near.cells().end(), 0.0) / double{NearCells::one};
}

TEST(NearCells, HoldWhatIsNearAndNothingElse) {
  LawnBelow lawn(0.08f);
  NearCells near;
  near.update(lawn.scene, 1, 2);
  EXPECT_NEAR(near.cell(), cell / 5, 1e-6f);
  double all = 0;  // coverage by all strands, in cell faces
  for (const GrownPart& part : lawn.fur.parts())
    for (std::size_t i = 0; i + 1 < part.strands->points.size(); ++i) {
      const StrandPoint &a = part.strands->points[i], &b = part.strands->points[i + 1];
      const bool one_strand = (i + 1) % static_cast<std::size_t>(part.strands->segments + 1) != 0;
      if (one_strand) all += double{(a.radius + b.radius) * glm::distance(a.position, b.position)};
    }
  all /= double{near.cell()} * double{near.cell()};
  EXPECT_GT(sum_of(near), 0.01 * all) << "the middle of the lawn";
  EXPECT_LT(sum_of(near), 0.5 * all);
  EXPECT_NEAR(near.mean() * NearCells::count / NearCells::one, sum_of(near), 0.001 * sum_of(near));
  lawn.look(0.5f);
  near.update(lawn.scene, 2, 2);
  EXPECT_TRUE(near.cells().empty());
  lawn.look(-0.1f);  // from below, looking away from the lawn
  near.update(lawn.scene, 3, 2);
  EXPECT_TRUE(near.cells().empty());
}

TEST(NearCells, HaveTheSameBitsForAnyThreads) {
  const LawnBelow lawn(0.08f);
  NearCells one, many;
  one.update(lawn.scene, 1, 1), many.update(lawn.scene, 1, 5);
  EXPECT_TRUE(std::equal(one.cells().begin(), one.cells().end(), many.cells().begin(), many.cells().end()));
}

TEST(NearCells, SayWhenWhatIsNearHasChanged) {
  LawnBelow lawn(0.08f);
  NearCells near;
  near.update(lawn.scene, 5, 2);
  EXPECT_EQ(near.since(), 5u);
  const double before = sum_of(near);
  std::fill(lawn.patch.length.begin(), lawn.patch.length.end(), 0.02f);
  lawn.grow();
  near.update(lawn.scene, 6, 2);
  EXPECT_EQ(near.since(), 6u);
  near.update(lawn.scene, 7, 2);
  EXPECT_EQ(near.since(), 6u) << "nothing has changed";
  EXPECT_LT(sum_of(near), 0.8 * before);
  lawn.scene.camera.position.x += 0.1f;
  near.update(lawn.scene, 8, 2);
  EXPECT_EQ(near.since(), 8u);
}

}  // namespace
}  // namespace pelage
