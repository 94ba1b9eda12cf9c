// Transfers a groom to a new version of its model.
#include "server/scene/new_version.h"

#include "server/groom/retarget.h"
#include "server/scene/scene.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::new_version_test {
namespace {

class NewVersion : public StoreTest {};

/// The lean of a vertex's fur as a vector in space.
glm::dvec3 lean(const Mesh& mesh, const FieldSet& fields, std::uint32_t v) {
  const glm::dvec2 direction(fields.value(Field::direction, v));
  const glm::dvec3 normal(mesh.normals[v]), tangent(mesh.tangents[v]);
  return direction.x * tangent + direction.y * glm::cross(normal, tangent);
}

TEST_F(NewVersion, TheSameMeshHasTheSameBits) {
  const auto scene = make(Builtin::creature, 3000), same = make(Builtin::creature, 3000);
  execute(*scene, {Comb{.flood = true, .direction = glm::dvec3(1, 0, 0)}});
  execute(*scene, {ChangeMask{.shape = MaskSphere{.centre = {0, 0.5, 0}, .radius = 0.3}}});
  const SnapshotPtr now = scene->snapshot();
  const TransferredGroom transferred = transferred_groom(*now, *same->model());
  EXPECT_EQ(transferred.fields.hash(), now->fields->hash());
  EXPECT_EQ(transferred.settings.eyes, now->settings->eyes);
  EXPECT_EQ(transferred.settings.coats[0].coat, now->settings->coats[0].coat);
  EXPECT_EQ(transferred.report.align, Alignment::none);
  EXPECT_EQ(transferred.report.far, 0u);
}

TEST_F(NewVersion, AFinerMeshHasTheFurOfTheOneBefore) {
  const auto scene = make(Builtin::creature, 3000), finer = make(Builtin::creature, 12000);
  execute(*scene, {Length{.flood = true, .brush = {.strength = 1}, .value = 0.09}});
  execute(*scene, {ChangeEditLayer{.name = "swept"}});
  execute(*scene, {Comb{.flood = true, .edit_layer = "swept", .direction = glm::dvec3(1, 0, 0)}});
  const SnapshotPtr now = scene->snapshot();
  const Surface &before = now->model->surface, &after = finer->model()->surface;
  const TransferredGroom transferred = transferred_groom(*now, *finer->model());
  ASSERT_EQ(transferred.report.vertices, after.mesh().positions.size());
  EXPECT_EQ(transferred.settings.layers, now->settings->layers);
  const double longer = length_factor(before.mesh(), after.mesh(), transferred.report.align);
  EXPECT_NEAR(transferred.fields.number(Field::length, 0), 0.09 * longer, 1e-6);
  EXPECT_FALSE(transferred.fields.untouched(base_sheet, Field::direction)) << "the layer goes along";
  const NearestCorners nearest = nearest_corners(after.mesh(), before, transferred.report.align);
  double mean = 0;
  for (std::uint32_t v = 0; v < nearest.corners.size(); ++v) {
    glm::dvec3 there(0);
    for (const MixShare& share : nearest.corners[v])
      there += share.weight * lean(before.mesh(), *now->fields, share.vertex);
    mean += glm::distance(lean(after.mesh(), transferred.fields, v), there);
  }
  EXPECT_LT(mean / static_cast<double>(nearest.corners.size()), 0.05) << "over turns of the skin alone";
}

}  // namespace
}  // namespace pelage::new_version_test
