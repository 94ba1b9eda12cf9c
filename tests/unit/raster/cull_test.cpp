// Which strands are kept, and how much they are widened.
#include "renderer/raster/cull.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

struct Field {
  FurPatch patch{0.2, 4, 0.02f};
  GrownFur fur;
  RasterScene scene;

  Field() {
    fur.update(patch.model(), patch.fields(), GrowRecipe{plain_coat()}, 1);
    scene.parts = fur.parts();
    scene.camera.scale = 500, scene.camera.middle = {100, 100};
    look_from(1);
  }
  void look_from(float height) {
    scene.camera.position = {0.1f, 0.1f, height};
    scene.camera.right = {1, 0, 0}, scene.camera.up = {0, 1, 0}, scene.camera.forward = {0, 0, -1};
  }
  KeptStrands kept(double a_pixel) {
    scene.quality.strands_a_pixel = a_pixel;
    KeptStrands strands;
    keep_strands(scene, fur.parts()[0], strands);
    return strands;
  }
};

TEST(Cull, StrandsThatAreLeftStandForAll) {
  Field field;
  const auto count = static_cast<double>(field.fur.parts()[0].strands->count());
  for (const double a_pixel : {0.02, 0.05, 0.1, 1e9}) {
    const KeptStrands kept = field.kept(a_pixel);
    EXPECT_NEAR(std::accumulate(kept.widened.begin(), kept.widened.end(), 0.0), count, 0.02 * count) << a_pixel;
  }
  EXPECT_EQ(static_cast<double>(field.kept(1e9).ids.size()), count);
  EXPECT_LT(static_cast<double>(field.kept(0.05).ids.size()), count / 2);
}

TEST(Cull, StrandsThatStandForMoreHaveLessOfTheirOwnColour) {
  Field field;
  for (const double a_pixel : {1e9, 0.25, 0.12, 0.06, 0.01}) {
    const double stands_for = field.kept(a_pixel).widened[0] * (1 - 0.125 / 2);  // the last eighth fades out
    EXPECT_NEAR(own_colour(field.scene, field.fur.parts()[0]), 1 / std::sqrt(std::max(stands_for, 1.0)), 1e-3)
        << a_pixel;
  }
}

TEST(Cull, StrandsCountByWhatTheyCover) {
  Knobs knobs;
  knobs.raster = {.strands = 1.5, .light_of = 4};
  EXPECT_EQ(quality_of(knobs, 1).strands_a_pixel, 1.5);
  EXPECT_EQ(quality_of(knobs, 4).strands_a_pixel, 0.75);
  const RasterQuality quality = quality_of(knobs, 1);
  EXPECT_DOUBLE_EQ(quality.drawn_strand_share(6, 0.1), 0.25);
  EXPECT_DOUBLE_EQ(quality.drawn_strand_share(6, 1), 1 / 1.5);  // no strand is widened further
  EXPECT_EQ(quality.drawn_strand_share(0.5, 0), 1);
  EXPECT_EQ(quality.drawn_strand_share(0, 0), 1);
}

// Otherwise a stroke would change strands that it does not touch and that are not drawn again.
TEST(Cull, LongerFurAtOnePositionChangesNoOtherStrand) {
  Field field;
  const KeptStrands before = field.kept(0.05);
  field.patch.length[0] *= 1.4f;
  ASSERT_GT(field.fur.update(field.patch.model(), field.patch.fields(), GrowRecipe{plain_coat()}, 1), 0u);
  field.scene.parts = field.fur.parts();
  const KeptStrands after = field.kept(0.05);
  EXPECT_EQ(after.ids, before.ids);
  EXPECT_EQ(after.widened, before.widened);
}

TEST(Cull, StrandsAppearAndVanishWithoutWidth) {
  Field field;
  KeptStrands before = field.kept(0.05);
  std::size_t came = 0;
  for (int step = 1; step < 200; ++step) {
    field.look_from(1 - 1e-3f * static_cast<float>(step));
    const KeptStrands now = field.kept(0.05);
    for (std::size_t i = 0; i < std::min(before.ids.size(), now.ids.size()); ++i)
      ASSERT_NEAR(now.widened[i], before.widened[i], 0.05f * now.widened[0]);
    for (std::size_t i = before.ids.size(); i < now.ids.size(); ++i, ++came)
      ASSERT_LT(now.widened[i], 0.05f * now.widened[0]);
    before = now;
  }
  EXPECT_GT(came, 10u);
}

TEST(Cull, NoPartThatShowsIsLeftOut) {
  Field field;
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(-1, 1);
  int shown = 0;
  for (int i = 0; i < 2000; ++i) {
    PictureCamera& camera = field.scene.camera;
    camera.position = {uniform(random), uniform(random), uniform(random)};
    camera.forward = glm::normalize(glm::vec3(uniform(random), uniform(random), uniform(random) + 1e-3f));
    camera.right = glm::normalize(glm::cross(camera.forward, glm::vec3(0, 0.1f, 1)));
    camera.up = glm::cross(camera.right, camera.forward);
    const PixelBox box{40, 60, 150, 170};
    for (const GrownPart& part : field.fur.parts()) {
      bool inside = false;
      for (const StrandPoint& point : part.strands->points) {
        const glm::vec3 apart = point.position - camera.position;
        const float distance = glm::dot(apart, camera.forward), scale = camera.scale / distance;
        const float x = camera.middle.x + glm::dot(apart, camera.right) * scale;
        const float y = camera.middle.y - glm::dot(apart, camera.up) * scale;
        inside = inside || (distance > near_distance && x > 40 && x < 150 && y > 60 && y < 170);
      }
      if (inside) {
        ASSERT_TRUE(shows_in(field.scene, part, box)) << i;
      }
      shown += inside ? 1 : 0;
    }
  }
  EXPECT_GT(shown, 50);
}

}  // namespace
}  // namespace pelage
