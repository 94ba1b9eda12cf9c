// What rays hit among strands.
#include "renderer/strands/world.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/strands/fur_patch.h"

namespace pelage {
namespace {

constexpr std::size_t enough_memory = std::size_t{1} << 30;

bool always() { return true; }

World::Change grown(World& world, const FurPatch& patch, const Coat& coat, FurFrame frame = {}) {
  const Result<World::Change> change =
      world.update(patch.model(), patch.fields(), frame, GrowRecipe{coat}, {1, false}, always);
  EXPECT_TRUE(change) << "no memory";
  return change ? *change : World::Change{};
}

/// A coat of few upright strands, .002 wide.
Coat thick_coat() {
  Coat coat = plain_coat(60);
  coat.width_root = coat.width_tip = 0.002;
  return coat;
}

/// A ray along y at half the first strand's height, `aside` from the strand's axis in x.
Ray past_first(const StrandSet& set, float aside) {
  const StrandPoint root = knot(set, 0, 0), end = tip(set, 0);
  const glm::vec3 middle = 0.5f * (root.position + end.position);
  return {.origin = middle + glm::vec3(aside, -0.001f * 5, 0), .direction = {0, 1, 0}};
}

TEST(World, RaysHitAStrandWhereItIs) {
  FurPatch patch(0.12);
  World world(enough_memory);
  grown(world, patch, thick_coat());
  const StrandSet set = patch.grow({thick_coat()});
  for (const float offset : {-0.9f, -0.3f, 0.0f, 0.6f}) {
    const Hit hit = world.intersect(past_first(set, offset * 0.001f));
    ASSERT_EQ(hit.kind, HitKind::strand);
    EXPECT_NEAR(hit.distance, 0.005f, 2e-4f);
    EXPECT_NEAR(hit.tangent.z, 1, 1e-4f);
    EXPECT_NEAR(hit.normal.z, 1, 1e-6f);
    EXPECT_NEAR(hit.height, 0.5f, 1e-2f);
    EXPECT_NEAR(hit.radius, 0.001f, 1e-6f);
    EXPECT_NEAR(std::abs(hit.offset), std::abs(offset), 1e-2f);
    // h as in offset_across of tests/double_shading: from the normal on the round strand and the direction to the
    // camera.
    const glm::vec3 on_strand(offset, -std::sqrt(1 - offset * offset), 0);
    const float h = -glm::dot(hit.tangent, glm::cross(on_strand, glm::vec3(0, -1, 0)));
    EXPECT_NEAR(hit.offset, h, 1e-2f);
    EXPECT_NEAR(hit.colour.r, 0.4f, 2e-3f);
  }
  EXPECT_NE(world.intersect(past_first(set, 0.0011f)).strand, world.intersect(past_first(set, 0)).strand);
}

TEST(World, RaysHitTheStrandsOfAllCoats) {
  FurPatch patch(0.12);
  Coat other = thick_coat();
  other.seed = 5, other.ramp = {{0, {0, 0, 1}}};
  const std::vector<FurFields> fields(2, patch.fields());
  const std::vector<GrowRecipe> recipes{GrowRecipe{thick_coat()}, GrowRecipe{other}};
  World world(enough_memory);
  const Result<World::Change> change = world.update(patch.model(), fields, FurFrame{}, recipes, {1, false}, always);
  ASSERT_TRUE(change);
  const StrandSet first = patch.grow(recipes[0]), second = patch.grow(recipes[1]);
  EXPECT_EQ(change->strands, first.count() + second.count());
  EXPECT_NEAR(world.intersect(past_first(first, 0)).colour.r, 0.4f, 2e-3f);
  EXPECT_GT(world.intersect(past_first(second, 0)).colour.b, 0.9f);
  EXPECT_EQ(world.update(patch.model(), fields, FurFrame{}, recipes, {1, false}, always)->grown, 0u);
  ASSERT_TRUE(world.update(patch.model(), fields[0], FurFrame{}, recipes[0], {1, false}, always));
  EXPECT_LT(world.intersect(past_first(second, 0)).colour.b, 0.9f) << "one alone";
}

TEST(World, AStrandIsLeftOutByRaysThatStartOnIt) {
  FurPatch patch(0.12);
  World world(enough_memory);
  grown(world, patch, thick_coat());
  Ray ray = past_first(patch.grow({thick_coat()}), 0);
  const Hit first = world.intersect(ray);
  ray.ignored = first.strand;
  EXPECT_NE(world.intersect(ray).strand, first.strand);
  Ray short_ray = ray;
  short_ray.t_max = 0.007f;
  EXPECT_FALSE(world.occluded(short_ray));
  short_ray.ignored = {};
  EXPECT_TRUE(world.occluded(short_ray));
}

TEST(World, LightPassesStrandsByColourAndCount) {
  FurPatch patch(0.12);
  World world(enough_memory);
  Coat coat = thick_coat();
  for (const float red : {0.0f, 0.25f, 1.0f}) {
    coat.ramp = {{0, {red, 0, 1}}};
    grown(world, patch, coat);
    const StrandSet set = patch.grow({coat});
    for (const float aside : {0.0f, 0.013f, 0.031f}) {
      const Ray ray{.origin = knot(set, 0, 0).position + glm::vec3(aside, -1, 0.012f), .direction = {0, 1, 0}};
      int crossed = 0;
      for (std::size_t i = 0; i < set.count(); ++i) {
        if (std::abs(knot(set, i, 0).position.x - ray.origin.x) < 0.001f) ++crossed;
      }
      const glm::vec3 transmittance = world.transmittance(ray, 0.4f);
      const float depth = 0.4f * static_cast<float>(crossed);
      EXPECT_NEAR(transmittance.r, std::exp(-depth * (1 - pale_transmittance * std::sqrt(red))), 2e-3f) << crossed;
      EXPECT_NEAR(transmittance.g, std::exp(-depth), 1e-5f);
      EXPECT_NEAR(transmittance.b, std::exp(-depth * (1 - pale_transmittance)), 2e-3f);
    }
  }
}

TEST(World, SkinAndEyesStopLight) {
  FurPatch patch(0.12, 2, 0);  // without fur
  World world(enough_memory);
  FurFrame frame;
  frame.eyes.resize(1);
  frame.eyes[0].position = {0, 0, 1}, frame.eyes[0].radius = 0.1f;
  EXPECT_EQ(grown(world, patch, thick_coat(), frame).strands, 0u);
  const Ray down{.origin = {0.05f, 0.05f, 0.5f}, .direction = {0, 0, -1}};
  EXPECT_EQ(world.intersect(down).kind, HitKind::skin);
  EXPECT_NEAR(world.intersect(down).distance, 0.5f, 1e-6f);
  EXPECT_NEAR(world.intersect(down).normal.z, 1, 1e-6f);
  EXPECT_EQ(world.transmittance(down, 0), glm::vec3(0));
  EXPECT_EQ(world.transmittance({.origin = down.origin, .direction = {1, 0, 0}}, 1), glm::vec3(1));
  EXPECT_EQ(world.intersect({.origin = {0, 0, 0.5f}, .direction = {0, 0, 1}}).kind, HitKind::skin);
  EXPECT_EQ(world.intersect({.origin = {0, 1, 0.5f}, .direction = {0, 1, 0}}).kind, HitKind::none);
}

TEST(World, OnlyWhatChangedIsGrownAgain) {
  FurPatch patch(0.6, 40);
  Coat coat = plain_coat(4000);
  World world(enough_memory);
  const World::Change first = grown(world, patch, coat);
  EXPECT_EQ(first.grown, first.strands);
  EXPECT_GT(first.strands, 90'000u);
  EXPECT_EQ(grown(world, patch, coat).grown, 0u);
  patch.length[0] = 0.01f;
  const World::Change one = grown(world, patch, coat);
  EXPECT_GT(one.grown, 0u);
  EXPECT_LT(one.grown, first.strands / 4);
  EXPECT_EQ(one.strands, first.strands);
  coat.bend = 0.5;
  EXPECT_EQ(grown(world, patch, coat).grown, first.strands);
}

TEST(World, ReportsTooLittleMemoryAndRecovers) {
  const FurPatch patch(0.6, 10);
  World world(200'000);
  const Result<World::Change> much =
      world.update(patch.model(), patch.fields(), {}, GrowRecipe{plain_coat(4000)}, {2, false}, always);
  ASSERT_FALSE(much);
  EXPECT_EQ(much.status().code, Code::too_large);
  EXPECT_EQ(much.status().pointer, "/quality/trace/strands");
  EXPECT_LE(world.bytes(), 200'000u);
  EXPECT_GT(grown(world, FurPatch(0.05), plain_coat(100)).strands, 0u);
}

TEST(World, GrowingStopsWhenNobodyWaits) {
  const FurPatch patch(0.6, 10);
  World world(enough_memory);
  int asked = 0;
  const auto twice = [&asked] { return ++asked <= 2; };
  const Result<World::Change> change =
      world.update(patch.model(), patch.fields(), {}, GrowRecipe{plain_coat(4000)}, {1, false}, twice);
  ASSERT_FALSE(change);
  EXPECT_EQ(change.status().code, Code::unavailable);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(grown(world, patch, plain_coat(4000)).strands, patch.grow({plain_coat(4000)}).count());
}

}  // namespace
}  // namespace pelage
