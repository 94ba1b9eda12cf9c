// Faces with a material: the mask selects them, and the first groom leaves them bare if the material's name says so.
#include <gtest/gtest.h>

#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "tests/unit/groom/shapes.h"

namespace pelage {
namespace {

/// A ball whose upper faces are its teeth.
class MaterialsTest : public ::testing::Test {
 protected:
  static Surface ball() {
    RawModel raw = make_builtin({Builtin::sphere, 2000});
    raw.materials = {{{1, 1, 1}, -1, "Fur"}, {{1, 1, 1}, -1, "Teeth"}};
    std::size_t corner = 0;
    for (const std::uint32_t size : raw.face_sizes) {
      raw.face_material.push_back(raw.positions[raw.corners[corner]].y > 0.2 ? 1 : 0);
      corner += size;
    }
    Result<Mesh> mesh = prepare(raw);
    EXPECT_TRUE(mesh.ok());
    return Surface(std::move(*mesh));
  }
  /// Returns whether a vertex has triangles of that material.
  bool has(std::uint32_t vertex, const char* material) const {
    const Mesh& mesh = ball_.mesh();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        if (mesh.triangles[t][k] == vertex && mesh.report.materials[mesh.materials[t]].name == material) return true;
    return false;
  }
  static ChangeMask mask_of(const char* material) { return {.shape = MaskMaterial{material}}; }

  Surface ball_ = ball();
  FieldSet groom_ = first_groom(ball_.mesh(), {.length = 0.05});
};

TEST_F(MaterialsTest, TheMaskChoosesAllCornersOfAMaterial) {
  const ChangeMask mask = mask_of("Teeth");
  ASSERT_TRUE(resolve(mask, ball_).ok());
  FieldSet after = groom_;
  after.apply(evaluate(mask, ball_, groom_).delta);
  int chosen = 0;
  for (std::uint32_t v = 0; v < after.size(); ++v) {
    ASSERT_EQ(after.number(Field::mask, v), has(v, "Teeth") ? 1 : 0) << v;
    chosen += has(v, "Teeth") ? 1 : 0;
  }
  EXPECT_GT(chosen, 100);
}

TEST_F(MaterialsTest, AMaterialThatTheModelDoesNotHaveIsRefused) {
  const Result<Command> resolved = resolve(mask_of("Claws"), ball_);
  ASSERT_FALSE(resolved.ok());
  EXPECT_EQ(resolved.status().pointer, "/material/name");
  EXPECT_NE(resolved.status().limit.find("Teeth"), std::string::npos) << resolved.status().limit;
}

TEST_F(MaterialsTest, FurBeginsWhereAnyFaceHasFur) {
  for (std::uint32_t v = 0; v < groom_.size(); ++v)
    ASSERT_EQ(groom_.number(Field::bare, v), has(v, "Fur") ? 0 : 1) << v;
}

}  // namespace
}  // namespace pelage
