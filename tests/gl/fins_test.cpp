// Fins and guard hairs: only at silhouettes, never in the way of a frame that did not ask for them.
#include <algorithm>
#include <cmath>
#include <set>

#include "renderer/coat/side_view.h"
#include "renderer/passes/fins/fins_pass.h"
#include "server/frames/fur_view.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {
namespace {

FrameRequest request_with(bool fins, int hairs, int size = 192) {
  FrameRequest request = small_frame(AutoView::three_quarter, size);
  request.knobs.fins = fins;
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

class Fins : public WithRenderer {};

TEST_P(Fins, AFrameWithoutThemIsAsBefore) {
  const FurredModel model = furred({Builtin::creature, 3000});
  const Image before = draw(*renderer, model, request_with(false, 0));
  const Image with = draw(*renderer, model, request_with(true, 3000));
  EXPECT_NE(before.rgba, with.rgba);
  EXPECT_EQ(before.rgba, draw(*renderer, model, request_with(false, 0)).rgba);  // no state of theirs is left behind
  EXPECT_EQ(with.rgba, draw(*renderer, model, request_with(true, 3000)).rgba);
}

TEST_P(Fins, ChangeTheSilhouetteAndHardlyTheInside) {
  const FurredModel model = furred({Builtin::sphere, 3000}, {.length = 0.05, .inclination = 0.4});
  const Image plain = draw(*renderer, model, request_with(false, 0));
  const Change fins = change_between(plain, draw(*renderer, model, request_with(true, 0)), 12);
  EXPECT_GT(fins.band, 1);
  EXPECT_LT(fins.inside, 0.1);
  EXPECT_LT(fins.outside, 0.1);
  const Change hairs = change_between(plain, draw(*renderer, model, request_with(false, 20000)), 12);
  EXPECT_GT(hairs.band, 2);
  EXPECT_LT(hairs.inside, 0.1);
  EXPECT_LT(hairs.outside, 0.1);
  RecordProperty("fins", std::to_string(fins.band) + " " + std::to_string(fins.inside));
  RecordProperty("hairs", std::to_string(hairs.band) + " " + std::to_string(hairs.inside));
}

/// An edge that is narrower than a slab of the side view stands for the fur of its own width: there, what fins add does
/// not grow with the number of edges. (Wider edges show one slab each, so that coarse meshes get thinner fins.)
TEST_P(Fins, AddAsMuchHoweverFineTheMeshIs) {
  const auto added = [&](int triangles) {
    FurredModel model = furred({Builtin::sphere, triangles}, {.length = 0.05, .inclination = 0.2});
    model.settings.coat.tile = 1, model.settings.coat.count = 3000;  // slabs of .008, and thin fur
    const Image plain = draw(*renderer, model, request_with(false, 0, 128));
    const Image fins = draw(*renderer, model, request_with(true, 0, 128));
    double sum = 0;
    for (std::size_t i = 3; i < plain.rgba.size(); i += 4) sum += fins.rgba[i] - plain.rgba[i];
    return sum;
  };
  const double coarse = added(12000), fine = added(48000);
  RecordProperty("sums", std::to_string(coarse) + " " + std::to_string(fine));
  EXPECT_GT(coarse, 500);
  EXPECT_NEAR(fine / coarse, 1, 0.25);
}

TEST_P(Fins, RootsOfGuardHairsDoNotShowThroughTheFur) {
  FurredModel model = furred({Builtin::sphere, 3000}, {.length = 0.05, .inclination = 0.4});
  model.settings.coat.ramp = {{0, {0, 0, 0}}, {0.6, {0, 0, 0}}, {0.7, {0.7f, 0.7f, 0.7f}}, {1, {0.7f, 0.7f, 0.7f}}};
  const double plain = mean_colour(draw(*renderer, model, request_with(false, 0))).g;
  const double hairs = mean_colour(draw(*renderer, model, request_with(false, 20000))).g;
  RecordProperty("means", std::to_string(plain) + " " + std::to_string(hairs));
  EXPECT_GT(hairs, plain - 2);
}

TEST_P(Fins, NoFurNoFins) {
  const FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0});
  EXPECT_EQ(draw(*renderer, model, request_with(false, 0)).rgba, draw(*renderer, model, request_with(true, 5000)).rgba);
}

TEST_P(Fins, NothingPopsWhenTheCameraMoves) {
  // Few, long edges, and steps so small that plain fur hardly changes.
  const FurredModel model = furred({Builtin::sphere, 200}, {.length = 0.08, .inclination = 0.2});
  const auto largest_change = [&](bool fins, int hairs) {
    FrameRequest request = request_with(fins, hairs, 96);
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
  const double plain = largest_change(false, 0), fins = largest_change(true, 0), hairs = largest_change(false, 3000);
  RecordProperty("means", std::to_string(plain) + " " + std::to_string(fins) + " " + std::to_string(hairs));
  EXPECT_LT(fins, 1.25 * plain);
  EXPECT_LT(hairs, 1.25 * plain);
}

TEST_P(Fins, FollowTheFields) {
  FurredModel model = furred({Builtin::sphere, 1000}, {.length = 0.03});
  const Image before = draw(*renderer, model, request_with(true, 5000));
  for (std::uint32_t v = 0; v < model.fields.size(); ++v) {
    Groom groom = model.fields.at(v);
    groom.length = 0.09f;
    model.fields.set(v, groom);
  }
  const Image longer = draw(*renderer, model, request_with(true, 5000));
  EXPECT_GT(covered(longer), 1.05 * covered(before));
  renderer->forget(model.model.id);
  EXPECT_EQ(longer.rgba, draw(*renderer, model, request_with(true, 5000)).rgba);
}

TEST_P(Fins, ExtremesGiveFinitePictures) {
  for (const double length : {0.0, 1e-6, 10.0}) {
    for (const double inclination : {0.0, 1.0}) {
      FurredModel model = furred({Builtin::sphere, 300}, {.length = length, .inclination = inclination});
      model.settings.lights = {{.kind = LightKind::point, .position = {0, 0, 0}, .intensity = 1e8}};
      model.settings.look.specular_exponent = 1e6;
      FrameRequest request = request_with(true, 500, 24);
      request.background = Background::colour;
      const Image image = draw(*renderer, model, request);
      for (std::size_t i = 3; i < image.rgba.size(); i += 4) ASSERT_EQ(image.rgba[i], 255);  // a NaN would leave 0
    }
  }
}

TEST_P(Fins, GoWithPatternsAndEveryShadingModel) {
  FurredModel model = furred({Builtin::creature, 1000});
  model.settings.coat.pattern.kind = PatternKind::stripes;
  for (const ShadingModel shading : {ShadingModel::lengyel, ShadingModel::kajiya, ShadingModel::marschner}) {
    model.settings.look.shading = shading;
    const Image plain = draw(*renderer, model, request_with(false, 0, 96));
    EXPECT_NE(plain.rgba, draw(*renderer, model, request_with(true, 2000, 96)).rgba);
  }
}

/// Pixels inside the skin of a bare model, away from its silhouette, that fins or hairs change.
int changed_on_skin(Renderer& renderer, BuiltinModel shape, const FurredModel& furry, bool fins, int hairs) {
  const FurredModel bare = furred(shape, {.length = 0});
  const Image skin = draw(renderer, bare, request_with(false, 0));
  renderer.forget(bare.model.id);
  const Image plain = draw(renderer, furry, request_with(false, 0)),
              with = draw(renderer, furry, request_with(fins, hairs));
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
TEST_P(Fins, InFrontOfTheSkinTheyShow) {
  const BuiltinModel knot{Builtin::knot, 3000};
  FurredModel model = furred(knot, {.length = 0.04, .inclination = 0.3});
  model.settings.coat.tile = 1, model.settings.coat.count = 3000;  // thin fur, which does not hide them
  EXPECT_GT(changed_on_skin(*renderer, knot, model, true, 0), 60);
  EXPECT_GT(changed_on_skin(*renderer, knot, model, false, 20000), 100);
}

INSTANTIATE_TEST_SUITE_P(Gl, Fins, both_backends(), name_of);

/// A square of two triangles, each of which comes as two pieces.
struct Square {
  std::vector<glm::vec3> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                   {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::vector<glm::vec3> normals = std::vector<glm::vec3>(8, {0, 0, 1});
  std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
  std::vector<std::uint32_t> welded{0, 1, 2, 3, 0, 1, 2, 3};
  StripMesh mesh() const { return {positions, normals, triangles, welded}; }
};

TEST(Strips, EachEdgeOfTheSurfaceOnce) {
  const Square square;
  EXPECT_EQ(surface_triangles(square.mesh()).size(), 2u);
  const std::vector<FinEdge> edges = list_edges(square.mesh());
  ASSERT_EQ(edges.size(), 5u);
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (const FinEdge& edge : edges) {
    seen.emplace(square.welded[edge.ends.x], square.welded[edge.ends.y]);
    const bool diagonal = edge.ends.x == 0 && edge.ends.y == 2;
    EXPECT_FLOAT_EQ(edge.width, diagonal ? 0.5f / std::sqrt(2.0f) : 0.25f);
  }
  EXPECT_EQ(seen.size(), 5u);
}

TEST(Strips, HairsSpreadOverTheArea) {
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

TEST(Strips, NothingOnASurfaceWithoutArea) {
  Square square;
  square.positions.assign(8, glm::vec3(0));
  EXPECT_TRUE(scatter_hairs(square.mesh(), 10).empty());
  EXPECT_TRUE(list_edges(square.mesh()).empty());
}

TEST(Strips, OnlyWhatIsSeenFromTheSideFarThingsFirst) {
  const Square square;
  const std::vector<FinEdge> edges = list_edges(square.mesh());
  EXPECT_TRUE(shown_fins(square.mesh(), edges, {0.5f, 0.5f, 3}).strips.empty());
  const ShownStrips<FinEdge> side = shown_fins(square.mesh(), edges, {3, 0.5f, 0.1f});
  EXPECT_EQ(side.strips.size(), 5u);
  EXPECT_EQ(side.back_facing, 0u);
  EXPECT_EQ(shown_fins(square.mesh(), edges, {3, 0.5f, -0.1f}).back_facing, 5u);
  const ShownStrips<HairRoot> hairs = shown_hairs(square.mesh(), scatter_hairs(square.mesh(), 100), {3, 0.5f, 0.1f});
  const auto x_of = [&](const HairRoot& root) {
    float x = 0;
    for (int k = 0; k < 3; ++k) x += root.weights[k] * square.positions[root.corners[k]].x;
    return x;
  };
  ASSERT_EQ(hairs.strips.size(), 100u);
  EXPECT_LT(x_of(hairs.strips.front()), x_of(hairs.strips.back()));
}

TEST(SideView, StrandsThinOutTowardsTheTips) {
  const Coat coat;
  const std::vector<glm::vec4> picture = bake_side_view(coat);
  const auto mean_opacity = [&](int y) {
    double sum = 0;
    for (int x = 0; x < side_view_width; ++x) sum += picture[static_cast<std::size_t>(y * side_view_width + x)].a;
    return sum / side_view_width;
  };
  EXPECT_GT(mean_opacity(2), 0.4);
  EXPECT_LT(mean_opacity(side_view_height - 2), 0.2 * mean_opacity(2));
  for (const glm::vec4& texel : picture)
    ASSERT_TRUE(texel.a >= 0 && texel.a <= 1 && texel.r >= 0 && std::isfinite(texel.r));
  EXPECT_EQ(picture, bake_side_view(coat));
}

}  // namespace
}  // namespace pelage::testing
