#include "renderer/visibility/changed_fur.h"

#include <gtest/gtest.h>

#include <array>

#include "protocol/commands/coat.h"

namespace pelage {
namespace {

/// Two triangles far from each other; x and y of a place are what a picture sees.
struct Skin {
  std::array<glm::vec3, 6> positions{
      {{-0.9, 0, 0}, {-0.8, 0, 0}, {-0.9, 0.1, 0}, {0.8, 0, 0}, {0.9, 0, 0}, {0.8, 0.1, 0}}};
  std::array<glm::vec3, 6> normals, tangents, groom;
  std::array<glm::uvec3, 2> triangles{{{0, 1, 2}, {3, 4, 5}}};

  Skin() { normals.fill({0, 0, 1}), tangents.fill({1, 0, 0}), groom.fill({0, 0, 0.05f}); }
  std::optional<ClipBox> changed(const ChangedFur& fur, std::uint64_t since) const {
    return fur.box({positions, normals, tangents, groom, triangles}, Coat(), glm::mat4(1), since);
  }
};

bool is_left(const std::optional<ClipBox>& box) { return box && box->high.x < 0; }
bool is_right(const std::optional<ClipBox>& box) { return box && box->low.x > 0; }

TEST(ChangedFur, EachWhoAsksIsToldWhatCameSince) {
  const Skin skin;
  ChangedFur fur;
  EXPECT_FALSE(skin.changed(fur, 0));
  fur.note(0, {0, 0, 0.05f});
  const std::uint64_t before_right = fur.count();
  EXPECT_TRUE(is_left(skin.changed(fur, 0)));
  fur.note(4, {0, 0, 0.05f});
  EXPECT_TRUE(is_right(skin.changed(fur, before_right)));
  EXPECT_FALSE(is_left(skin.changed(fur, 0)) || is_right(skin.changed(fur, 0))) << "it holds both";
  EXPECT_FALSE(skin.changed(fur, fur.count()));
}

TEST(ChangedFur, WhatIsTooLongAgoIsEverywhere) {
  const Skin skin;
  ChangedFur fur;
  for (int i = 0; i < 300000; ++i) fur.note(0, {0, 0, 0.05f});
  EXPECT_EQ(fur.count(), 300000u);
  const std::optional<ClipBox> all = skin.changed(fur, 0);
  ASSERT_TRUE(all);
  EXPECT_LE(all->low.x, -1);
  EXPECT_GE(all->high.x, 1);
  EXPECT_TRUE(is_left(skin.changed(fur, 200000)));
}

}  // namespace
}  // namespace pelage
