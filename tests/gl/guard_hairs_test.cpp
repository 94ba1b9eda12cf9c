// Guard hairs: only at silhouettes, never in the way of a frame that did not ask for them.
#include <algorithm>
#include <cmath>
#include <set>

#include "renderer/passes/guard_hairs/guard_hairs_pass.h"
#include "server/frames/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::guard_hairs_test {
namespace {

FrameRequest request_with(int hairs, int size = 192) {
  FrameRequest request = small_frame(AutoView::three_quarter, size);
  request.knobs.guard_hairs = hairs;
  return request;
}

/// Distance in pixels to the nearest pixel whose coverage (alpha over half) is the other one, up to `most`.
int to_silhouette(const Image& mask, int x, int y, int max) {
  const auto inside = [&](int u, int v) {
    if (u < 0 || v < 0 || u >= mask.width || v >= mask.height) return false;
    return mask.rgba[4 * static_cast<std::size_t>(v * mask.width + u) + 3] > 127;
  };
  int nearest = max;
  for (int v = y - max; v <= y + max; ++v) {
    for (int u = x - max; u <= x + max; ++u) {
      if (inside(u, v) != inside(x, y)) nearest = std::min(nearest, std::max(std::abs(u - x), std::abs(v - y)));
    }
  }
  return nearest;
}

struct Change {
  double band = 0, inside = 0, outside = 0;  // mean differences in 1/255
};

/// How two pictures differ near the silhouette of the first, and further away than `reach` pixels.
Change change_between(const Image& a, const Image& b, int reach) {
  Change sum, count;
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      const std::size_t i = 4 * static_cast<std::size_t>(y * a.width + x);
      const bool near = to_silhouette(a, x, y, reach)<reach, in = a.rgba[i + 3]> 127;
      double difference = 0;
      for (std::size_t k = 0; k < 4; ++k) difference += std::abs(int(a.rgba[i + k]) - int(b.rgba[i + k])) / 4.0;
      (near ? sum.band : in ? sum.inside : sum.outside) += difference;
      (near ? count.band : in ? count.inside : count.outside) += 1;
    }
  }
  return {sum.band / count.band, sum.inside / count.inside, sum.outside / count.outside};
}

class GuardHairs : public WithRenderer {};

TEST_P(GuardHairs, AFrameWithoutThemIsAsBefore) {
  const FurredModel model = furred({Builtin::creature, 3000});
  const Image before = draw(*renderer, model, request_with(0));
  const Image with = draw(*renderer, model, request_with(3000));
  EXPECT_NE(before.rgba, with.rgba);
  EXPECT_EQ(before.rgba, draw(*renderer, model, request_with(0)).rgba);  // no state of theirs is left behind
  EXPECT_EQ(with.rgba, draw(*renderer, model, request_with(3000)).rgba);
}

TEST_P(GuardHairs, ChangeTheSilhouetteAndHardlyTheInside) {
  const FurredModel model = furred({Builtin::sphere, 3000}, {.length = 0.05, .inclination = 0.4});
  const Image plain = draw(*renderer, model, request_with(0));
  const Change hairs = change_between(plain, draw(*renderer, model, request_with(20000)), 12);
  EXPECT_GT(hairs.band, 2);
  EXPECT_LT(hairs.inside, 0.1);
  EXPECT_LT(hairs.outside, 0.1);
  RecordProperty("hairs", std::to_string(hairs.band) + " " + std::to_string(hairs.inside));
}

TEST_P(GuardHairs, RootsDoNotShowThroughTheFur) {
  FurredModel model = furred({Builtin::sphere, 3000}, {.length = 0.05, .inclination = 0.4});
  model.settings.coat.ramp = {{0, {0, 0, 0}}, {0.6, {0, 0, 0}}, {0.7, {0.7f, 0.7f, 0.7f}}, {1, {0.7f, 0.7f, 0.7f}}};
  const double plain = mean_colour(draw(*renderer, model, request_with(0))).g;
  const double hairs = mean_colour(draw(*renderer, model, request_with(20000))).g;
  RecordProperty("means", std::to_string(plain) + " " + std::to_string(hairs));
  EXPECT_GT(hairs, plain - 2);
}

TEST_P(GuardHairs, NoFurNoHairs) {
  const FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0});
  EXPECT_EQ(draw(*renderer, model, request_with(0)).rgba, draw(*renderer, model, request_with(5000)).rgba);
}

TEST_P(GuardHairs, NothingPopsWhenTheCameraMoves) {
  // Few, long edges, and steps so small that plain fur hardly changes.
  const FurredModel model = furred({Builtin::sphere, 200}, {.length = 0.08, .inclination = 0.2});
  const auto largest_change = [&](int hairs) {
    FrameRequest request = request_with(hairs, 96);
    request.camera.automatic = AutoView::none;
    request.camera.target = {0, 0, 0};
    double largest = 0;
    Image last;
    for (int step = 0; step < 24; ++step) {
      request.camera.position = {0.003 * step, 0, 3};
      const Image image = draw(*renderer, model, request);
      if (step > 0) largest = std::max(largest, mean_difference(image, last));
      last = image;
    }
    return largest;
  };
  const double plain = largest_change(0), hairs = largest_change(3000);
  RecordProperty("means", std::to_string(plain) + " " + std::to_string(hairs));
  EXPECT_LT(hairs, 1.25 * plain);
}

TEST_P(GuardHairs, FollowTheFields) {
  FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0.03});
  const Image before = draw(*renderer, model, request_with(5000));
  for (std::uint32_t v = 0; v < model.fields.size(); ++v) {
    Groom groom = model.fields.at(v);
    groom.length = 0.09f;
    model.fields.set(v, groom);
  }
  const Image longer = draw(*renderer, model, request_with(5000));
  EXPECT_GT(covered(longer), 1.05 * covered(before));
  renderer->forget(model.model.id);
  EXPECT_EQ(longer.rgba, draw(*renderer, model, request_with(5000)).rgba);
}

TEST_P(GuardHairs, ExtremesGiveFinitePictures) {
  for (const double length : {0.0, 1e-6, 10.0}) {
    for (const double inclination : {0.0, 1.0}) {
      FurredModel model = furred({Builtin::sphere, 300}, {.length = length, .inclination = inclination});
      model.settings.lights = {{.kind = LightKind::point, .position = {0, 0, 0}, .intensity = 1e8}};
      model.settings.look.specular_exponent = 1e6;
      FrameRequest request = request_with(500, 24);
      request.background = Background::colour;
      const Image image = draw(*renderer, model, request);
      for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);  // a NaN would leave 0
    }
  }
}

TEST_P(GuardHairs, GoWithPatternsAndEveryShadingModel) {
  FurredModel model = furred({Builtin::creature, 1000});
  model.settings.coat.pattern.kind = PatternKind::stripes;
  for (const ShadingModel shading : {ShadingModel::lengyel, ShadingModel::kajiya, ShadingModel::marschner}) {
    model.settings.look.shading = shading;
    const Image plain = draw(*renderer, model, request_with(0, 96));
    EXPECT_NE(plain.rgba, draw(*renderer, model, request_with(2000, 96)).rgba);
  }
}

/// Pixels inside the skin of a bare model, away from its silhouette, that hairs change.
int changed_on_skin(Renderer& renderer, BuiltinModel shape, const FurredModel& furry, int hairs) {
  const FurredModel bare = furred(shape, {.length = 0});
  const Image skin = draw(renderer, bare, request_with(0));
  renderer.forget(bare.model.id);
  const Image plain = draw(renderer, furry, request_with(0)), with = draw(renderer, furry, request_with(hairs));
  renderer.forget(furry.model.id);
  const auto inside = [&](int x, int y) {
    return skin.rgba[4 * static_cast<std::size_t>(y * skin.width + x) + 3] == 255;
  };
  int changed = 0;
  for (int y = 2; y + 2 < skin.height; ++y) {
    for (int x = 2; x + 2 < skin.width; ++x) {
      if (!inside(x - 2, y) || !inside(x + 2, y) || !inside(x, y - 2) || !inside(x, y + 2)) continue;
      const std::size_t i = 4 * static_cast<std::size_t>(y * skin.width + x);
      int max = 0;
      for (std::size_t c = i; c < i + 3; ++c) max = std::max(max, std::abs(with.rgba[c] - plain.rgba[c]));
      changed += max > 4;
    }
  }
  return changed;
}

/// Where one part of a knot lies before another, its silhouette is seen before skin: with a depth of far away nothing
/// of it would be left there.
TEST_P(GuardHairs, InFrontOfTheSkinTheyShow) {
  const BuiltinModel knot{Builtin::knot, 3000};
  FurredModel model = furred(knot, {.length = 0.04, .inclination = 0.3});
  model.settings.coat.tile = 1, model.settings.coat.count = 3000;  // thin fur, which does not hide them
  EXPECT_GT(changed_on_skin(*renderer, knot, model, 20000), 100);
}

INSTANTIATE_TEST_SUITE_P(Gl, GuardHairs, both_backends(), name_of);

/// A square of two triangles, each of which comes as two pieces.
struct Square {
  std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::vector<glm::vec3> normals = std::vector<glm::vec3>(8, {0, 0, 1});
  std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  std::vector<std::uint32_t> welded{0, 1, 2, 3, 0, 1, 2, 3};
  HairMesh mesh() const { return {positions, normals, triangles, welded}; }
};

TEST(GuardHairRoots, SpreadOverTheArea) {
  const Square square;
  const std::vector<HairRoot> roots = scatter_hairs(square.mesh(), 4000);
  ASSERT_EQ(roots.size(), 4000u);
  std::array<int, 4> quarters{};
  for (const HairRoot& root : roots) {
    ASSERT_NEAR(root.weights.x + root.weights.y + root.weights.z, 1, 1e-5);
    glm::vec3 place(0);
    for (int k = 0; k < 3; ++k) place += root.weights[k] * square.positions[root.corners[k]];
    ++quarters[static_cast<std::size_t>((place.x > 0.5f) + 2 * (place.y > 0.5f))];
  }
  for (const int count : quarters) EXPECT_NEAR(count, 1000, 120);
}

TEST(GuardHairRoots, NothingOnASurfaceWithoutArea) {
  Square square;
  square.positions.assign(8, glm::vec3(0));
  EXPECT_TRUE(scatter_hairs(square.mesh(), 10).empty());
}

TEST(GuardHairRoots, OnlyWhatIsSeenFromTheSideFarThingsFirst) {
  const Square square;
  const std::vector<HairRoot> roots = scatter_hairs(square.mesh(), 100);
  EXPECT_TRUE(shown_hairs(square.mesh(), roots, {0.5f, 0.5f, 3}).roots.empty());
  const ShownHairs hairs = shown_hairs(square.mesh(), roots, {3, 0.5f, 0.1f});
  EXPECT_EQ(hairs.back_facing, 0u);
  EXPECT_EQ(shown_hairs(square.mesh(), roots, {3, 0.5f, -0.1f}).back_facing, 100u);
  const auto x_of = [&](const HairRoot& root) {
    float x = 0;
    for (int k = 0; k < 3; ++k) x += root.weights[k] * square.positions[root.corners[k]].x;
    return x;
  };
  ASSERT_EQ(hairs.roots.size(), 100u);
  EXPECT_LT(x_of(hairs.roots.front()), x_of(hairs.roots.back()));
}

}  // namespace
}  // namespace pelage::testing::guard_hairs_test
