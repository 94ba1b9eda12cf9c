// Cards along the clumps of the fur, read independently of their writer.
#include "server/export/cards.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "server/export/card_texture.h"
#include "server/export/clumps.h"
#include "tests/support/furred_model.h"
#include "tests/support/glb_file.h"
#include "tests/unit/export/maned.h"

namespace pelage::testing::cards_test {
namespace {

constexpr float fur_length = 0.05f;

FurredModel furred_ball() { return furred({Builtin::sphere, 500}, {.length = fur_length, .inclination = 0.5}); }

ExportRequest asked(int cards) {
  ExportRequest request;
  request.format = ExportFormat::cards, request.cards = cards;
  return request;
}

struct Cards {
  CardFile file;
  GlbFile glb;

  Cards(const FurredModel& model, int cards)
      : file(bake_cards(model.view(), gather_strands(model.view(), asked(cards)).value(), asked(cards)).value()),
        glb(file.glb) {}

  /// The first primitive of the mesh with this name.
  nlohmann::json primitive(const std::string& name) const {
    for (const auto& mesh : glb.json["meshes"])
      if (mesh["name"] == name) return mesh["primitives"][0];
    return {};
  }
  std::size_t count(const nlohmann::json& accessor) const {
    return glb.json["accessors"][accessor.get<std::size_t>()]["count"];
  }
  std::size_t triangles(const std::string& name) const { return count(primitive(name)["indices"]) / 3; }
};

TEST(Cards, AreAboutAsManyAsWereAsked) {
  const FurredModel model = furred_ball();
  for (const int wanted : {200, 1500}) {
    const Cards cards(model, wanted);
    EXPECT_NEAR(static_cast<double>(cards.file.cards), wanted, 0.2 * wanted);
    EXPECT_EQ(cards.triangles("fur_LOD0"), 10 * cards.file.cards) << "five quads each";
    EXPECT_EQ(cards.file.triangles, cards.triangles("body") + cards.triangles("fur_LOD0"));
  }
}

TEST(Cards, HaveASceneForEachLevelAndFewerInEachNext) {
  const Cards cards(furred_ball(), 1000);
  const auto& scenes = cards.glb.json["scenes"];
  ASSERT_EQ(scenes.size(), 3u);
  std::vector<int> nodes;
  for (const auto& scene : scenes) {
    EXPECT_EQ(scene["nodes"].size(), 2u);
    for (const auto& node : scene["nodes"]) nodes.push_back(node);
  }
  std::sort(nodes.begin(), nodes.end());
  EXPECT_EQ(std::unique(nodes.begin(), nodes.end()), nodes.end()) << "no node is in two scenes";
  const double half = static_cast<double>(cards.triangles("fur_LOD1")) / 6 / static_cast<double>(cards.file.cards);
  const double quarter = static_cast<double>(cards.triangles("fur_LOD2")) / 4 / static_cast<double>(cards.file.cards);
  EXPECT_NEAR(half, 0.5, 0.12);
  EXPECT_NEAR(quarter, 0.25, 0.08);
}

/// The ball's radius is .5 / sqrt(3) sizes; no card reaches beyond the length of the fur plus half a card.
TEST(Cards, StandOnTheSkin) {
  const FurredModel model = furred_ball();
  const Cards cards(model, 1500);
  const double size = model.model.surface.mesh().size, radius = 0.5 / std::sqrt(3.0) * size;
  const auto& accessor =
      cards.glb.json["accessors"][cards.primitive("fur_LOD0")["attributes"]["POSITION"].get<std::size_t>()];
  for (int axis = 0; axis < 3; ++axis) {
    const double low = accessor["min"][axis], high = accessor["max"][axis];
    EXPECT_LT(high, radius + 1.3 * double{fur_length} * size);
    EXPECT_GT(high, radius);
    EXPECT_NEAR(low, -high, 0.03 * size);
  }
}

TEST(Cards, OfEachCoatHaveItsMaterial) {
  const FurredModel model = maned(furred_ball(), fur_length);
  const Cards cards(model, 1000);
  const auto& meshes = cards.glb.json["meshes"];
  ASSERT_EQ(meshes.size(), 4u) << "a body and three levels";
  for (std::size_t level = 1; level < meshes.size(); ++level) {
    const auto& primitives = meshes[level]["primitives"];
    ASSERT_EQ(primitives.size(), 2u);
    const auto name = [&](std::size_t k) {
      return cards.glb.json["materials"][primitives[k]["material"].get<std::size_t>()]["name"];
    };
    EXPECT_EQ(name(0), "fur");
    EXPECT_EQ(name(1), "mane");
    const auto& mane = cards.glb.json["accessors"][primitives[1]["attributes"]["POSITION"].get<std::size_t>()];
    EXPECT_GT(mane["min"][0], -0.15 * model.model.surface.mesh().size);
  }
  EXPECT_EQ(cards.glb.json["textures"].size(), 2u);
  EXPECT_NEAR(static_cast<double>(cards.file.cards), 1000, 200);
}

TEST(Cards, AreLeftOutWithoutFur) {
  FurredModel model = furred_ball();
  for (std::uint32_t v = 0; v < model.fields.size(); ++v) model.fields.set(Field::length, v, glm::vec4(0));
  const Cards cards(model, 500);
  EXPECT_EQ(cards.file.cards, 0u);
  EXPECT_EQ(cards.glb.json["meshes"].size(), 1u);
  EXPECT_EQ(cards.glb.json["scenes"].size(), 3u);
}

/// Two strands with roots in one grid cell, on opposite sides of a thin sheet.
TEST(Clumps, KeepTheSidesOfAThinSheetApart) {
  StrandSet set;
  set.segments = 1;
  for (const float side : {1.0f, -1.0f}) {
    set.points.push_back({{0.5f, 0.5f, 0.5f}, 0.001f});
    set.points.push_back({{0.5f, 0.5f, 0.5f + 0.1f * side}, 0.001f});
    set.colours.insert(set.colours.end(), 2, pack_colour(glm::vec3(0.5f)));
    set.roots.push_back({.normal = {0, 0, side}, .number = 0.2f});
  }
  ExportedStrands strands;
  strands.sets.push_back(set), strands.group_of.push_back(0);
  EXPECT_EQ(make_clumps(strands, 0.3).size(), 2u);
  strands.sets.front().roots[1].normal = {0, 0, 1};
  const std::vector<CardLine> one = make_clumps(strands, 0.3);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_NEAR(one.front().positions.back().z, 0.5f, 1e-6f) << "the mean of both";
}

/// The card is opaque at the roots and sparse at the tips.
TEST(CardTexture, IsDenseAtTheRootsAndOpenAtTheTips) {
  const Image image = card_texture(Coat{}, 0.03);
  const auto cover = [&](int y) {
    double sum = 0;
    for (int x = 0; x < image.width; ++x)
      sum += image.rgba[4 * static_cast<std::size_t>(y * image.width + x) + 3] / 255.0;
    return sum / image.width;
  };
  EXPECT_GT(cover(image.height - 1), 0.7);
  EXPECT_LT(cover(0), 0.2);
  EXPECT_GT(cover(image.height / 2), cover(10));
}

/// Locks must not bleed into their neighbours, not even with the thickest strands.
TEST(CardTexture, HasFreeSidesAroundEachLock) {
  Coat thick;
  thick.width_root = thick.width_tip = 0.05;
  for (const Coat& coat : {Coat{}, thick}) {
    const Image image = card_texture(coat, 0.03);
    const int lock = image.width / card_locks;
    for (int y = 0; y < image.height; ++y) {
      for (const int x : {0, lock - 1, lock, image.width - 1})
        ASSERT_EQ(image.rgba[4 * static_cast<std::size_t>(y * image.width + x) + 3], 0) << x << ' ' << y;
    }
  }
}

}  // namespace
}  // namespace pelage::testing::cards_test
