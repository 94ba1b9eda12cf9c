// A stroke and its mirror images, where they overlap.
#include "server/groom/together.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "server/surface/prepare.h"

namespace pelage::together_test {
namespace {

/// A ball of eight octants that mirror each other bit for bit.
Surface octasphere(int rows) {
  RawModel raw;
  const auto add = [&](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 signs) {
    const bool turned = signs.x * signs.y * signs.z < 0;
    for (const glm::dvec3& p : turned ? std::array{a, c, b} : std::array{a, b, c}) {
      raw.corners.push_back(static_cast<std::uint32_t>(raw.positions.size()));
      raw.positions.push_back(signs * p / glm::length(p));
    }
    raw.face_sizes.push_back(3);
  };
  for (int octant = 0; octant < 8; ++octant) {
    const glm::dvec3 signs(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
    for (int i = 0; i < rows; ++i) {
      for (int j = 0; i + j < rows; ++j) {
        const auto at = [&](int x, int y) { return glm::dvec3(x, y, rows - x - y); };
        add(at(i, j), at(i + 1, j), at(i, j + 1), signs);
        if (i + j + 1 < rows) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), signs);
      }
    }
  }
  return Surface(prepare(raw).value());
}

class Together : public ::testing::Test {
 protected:
  FieldSet after(const Command& command, const Symmetry& symmetry) const {
    std::vector<FieldDelta> changes;
    for (const Command& image : symmetry_images(command, symmetry, ball_))
      changes.push_back(evaluate(image, ball_, fields_).delta);
    FieldSet done = fields_;
    done.apply(combine_symmetry_images(changes, fields_));
    return done;
  }

  static Stroke through(const std::vector<glm::dvec3>& positions) {
    Stroke stroke;
    for (const glm::dvec3& p : positions) stroke.samples.push_back({PositionSample{p / glm::length(p)}});
    return stroke;
  }

  Surface ball_ = octasphere(16);
  FieldSet fields_ = first_groom(ball_.mesh(), {.inclination = 0});
  Symmetry mirror_ = [] {
    Symmetry symmetry;
    symmetry.planes = {Plane{{0, 0, 0}, {1, 0, 0}}};
    return symmetry;
  }();
};

TEST_F(Together, AStrokeOnThePlaneIsNotDoubled) {
  Length longer;
  longer.mode = LengthMode::scale, longer.value = 1.5;
  longer.stroke = through({{0, 0.2, 1}, {0, 0.6, 1}});
  longer.brush.radius = 0.1;
  const FieldSet alone = after(longer, {}), mirrored = after(longer, mirror_);
  ASSERT_NE(alone.hash(), fields_.hash());
  EXPECT_EQ(mirrored.hash(), alone.hash());
}

TEST_F(Together, ACombAcrossThePlaneIsMirroredToRounding) {
  Comb comb;
  comb.stroke = through({{-0.4, 0.1, 1}, {-0.1, 0.2, 1}, {0.2, 0.4, 1}});
  comb.brush.radius = 0.12;
  const FieldSet combed = after(comb, mirror_);
  const Mesh& mesh = ball_.mesh();
  std::map<std::array<float, 3>, std::uint32_t> vertex_at;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 p = mesh.positions[v] + 0.0f;
    vertex_at[{p.x, p.y, p.z}] = v;
  }
  const auto in_space = [&](std::uint32_t v) {
    const glm::vec2 d = combed.direction()[v];
    return d.x * mesh.tangents[v] + d.y * glm::cross(mesh.normals[v], mesh.tangents[v]);
  };
  std::size_t changed = 0;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::vec3 p = mesh.positions[v];
    const auto other = vertex_at.find({-p.x + 0.0f, p.y + 0.0f, p.z + 0.0f});
    ASSERT_NE(other, vertex_at.end());
    const glm::vec3 change = in_space(v) - glm::vec3(-1, 1, 1) * in_space(other->second);
    changed += combed.direction()[v] != fields_.direction()[v] ? 1 : 0;
    EXPECT_LT(glm::length(change), 1e-5f) << p.x << " " << p.y << " " << p.z;
  }
  EXPECT_GT(changed, 20u);
}

TEST_F(Together, TheBrushsOwnSymmetryTakesThePlaceOfTheScenesWithAStrokeAndWithout) {
  Length longer;
  longer.mode = LengthMode::scale, longer.value = 1.5;
  longer.stroke = through({{0.8, 0.2, 0.4}});
  longer.brush.radius = 0.1;
  Attract pull;
  pull.point = {1.2, 0.2, 0.4}, pull.radius = 0.4, pull.strength = 1;
  const auto expect = [&](auto command) {
    const FieldSet alone = after(command, {}), mirrored = after(command, mirror_);
    ASSERT_NE(alone.hash(), mirrored.hash());
    command.brush.symmetry = mirror_;
    EXPECT_EQ(after(command, {}).hash(), mirrored.hash());
    command.brush.symmetry = Symmetry{};
    EXPECT_EQ(after(command, mirror_).hash(), alone.hash());
  };
  expect(longer), expect(pull);
}

TEST_F(Together, OneImageAloneKeepsItsChange) {
  Length longer;
  longer.mode = LengthMode::scale, longer.value = 1.5;
  longer.stroke = through({{0.8, 0.2, 0.4}});
  longer.brush.radius = 0.1;
  const FieldSet alone = after(longer, {}), mirrored = after(longer, mirror_);
  for (std::uint32_t v = 0; v < alone.size(); ++v) {
    if (ball_.mesh().positions[v].x > 0) {
      EXPECT_EQ(mirrored.length()[v], alone.length()[v]);
    }
  }
}

}  // namespace
}  // namespace pelage::together_test
