// A model that is rotated to another up and front, with its fur, across restarts.
#include "server/scene/scene.h"
#include "server/surface/prepare.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::turn_scene_test {
namespace {

constexpr TurnModel lying{.up = Axis::plus_z, .front = Axis::minus_y};

glm::dmat3 axes_rotation(const TurnModel& how) { return pelage::axes_rotation(how.up, how.front); }

/// The lean of the fur at each vertex as a vector in space.
std::vector<glm::dvec3> leans(const Scene& scene) {
  const SnapshotPtr now = scene.snapshot();
  const Mesh& mesh = now->model->surface.mesh();
  std::vector<glm::dvec3> leans;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const glm::dvec2 direction(now->fields->value(Field::direction, v));
    const glm::dvec3 normal(mesh.normals[v]), tangent(mesh.tangents[v]);
    leans.push_back(direction.x * tangent + direction.y * glm::cross(normal, tangent));
  }
  return leans;
}

double furthest(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b, const glm::dmat3& turn) {
  double largest = 0;
  for (std::size_t v = 0; v < a.size(); ++v) largest = std::max(largest, glm::length(turn * a[v] - b[v]));
  return largest;
}

class TurnSceneTest : public StoreTest {
 protected:
  SceneSummary turn(Scene& scene, const TurnModel& how = lying) {
    const auto summary = store_->turn(scene, how);
    EXPECT_TRUE(summary.ok()) << summary.status().message;
    return summary.ok() ? *summary : SceneSummary{};
  }
  std::shared_ptr<Scene> groomed() {
    auto scene = make(Builtin::creature, 800);
    EXPECT_TRUE(store_->execute(*scene, {comb_at(*scene, 5), comb_at(*scene, 200)}).ok());
    return scene;
  }
};

TEST_F(TurnSceneTest, FurEyesAndSkinTurnWithTheModel) {
  const auto scene = groomed();
  const SnapshotPtr before = scene->snapshot();
  const std::vector<glm::dvec3> stood = leans(*scene);
  const SceneSummary after = turn(*scene);
  const SnapshotPtr now = scene->snapshot();
  const glm::dmat3 rotation = axes_rotation(lying);
  EXPECT_EQ(after.revision, before->revision + 1);
  EXPECT_EQ(after.undo_steps, 0u);
  const Mesh &old = before->model->surface.mesh(), &mesh = now->model->surface.mesh();
  ASSERT_EQ(mesh.triangles, old.triangles);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    ASSERT_LT(glm::length(rotation * glm::dvec3(old.positions[v]) - glm::dvec3(mesh.positions[v])), 1e-6);
  EXPECT_LT(furthest(stood, leans(*scene), rotation), 1e-4);
  EXPECT_EQ(now->fields->length(), before->fields->length());
  const Eye &eye = now->settings->eyes.at(0), &stood_eye = before->settings->eyes.at(0);
  EXPECT_LT(glm::length(rotation * stood_eye.position - eye.position), 1e-9);
  EXPECT_LT(glm::length(rotation * stood_eye.gaze - eye.gaze), 1e-9);
  const SkinRegion &nose = now->settings->skin.at(0), &stood_nose = before->settings->skin.at(0);
  EXPECT_LT(glm::length(rotation * stood_nose.centre - nose.centre), 1e-9);
}

TEST_F(TurnSceneTest, FourQuartersBringItBack) {
  const auto scene = groomed();
  const auto model = scene->model();
  const std::vector<glm::dvec3> stood = leans(*scene);
  for (int quarter = 0; quarter < 4; ++quarter) turn(*scene);
  EXPECT_EQ(scene->model()->surface.mesh().positions, model->surface.mesh().positions);
  EXPECT_EQ(scene->model()->surface.mesh().report.up, model->surface.mesh().report.up);
  EXPECT_LT(furthest(stood, leans(*scene), glm::dmat3(1)), 1e-3);
}

TEST_F(TurnSceneTest, ARestartTurnsItAgain) {
  const auto scene = groomed();
  turn(*scene);
  ASSERT_TRUE(store_->subdivide(*scene, {}).ok());
  ASSERT_TRUE(store_->execute(*scene, {comb_at(*scene, 9)}).ok());
  const SceneSummary before = scene->summary();
  const auto model = scene->model();
  const std::string id = scene->id();
  open();
  const auto again = *store_->find(id);
  EXPECT_EQ(again->summary().fields_hash, before.fields_hash);
  EXPECT_EQ(again->model()->surface.mesh().positions, model->surface.mesh().positions);
  EXPECT_EQ(again->effective_log().size(), 1u);
}

TEST_F(TurnSceneTest, LayersTurnAlong) {
  const auto scene = make(Builtin::torus, 500);
  Comb comb = comb_at(*scene, 5);
  comb.edit_layer = "a";
  const auto mute = [&](bool muted) {
    const ChangeEditLayer change{.action = EditLayerAction::set, .name = "a", .muted = muted};
    EXPECT_TRUE(store_->execute(*scene, {change}).ok());
  };
  EXPECT_TRUE(store_->execute(*scene, {ChangeEditLayer{.action = EditLayerAction::add, .name = "a"}, comb}).ok());
  const std::vector<glm::dvec3> combed = leans(*scene);
  mute(true);
  const std::vector<glm::dvec3> plain = leans(*scene);
  EXPECT_GT(furthest(combed, plain, glm::dmat3(1)), 0.1);
  turn(*scene);
  EXPECT_LT(furthest(plain, leans(*scene), axes_rotation(lying)), 1e-4);
  mute(false);
  EXPECT_LT(furthest(combed, leans(*scene), axes_rotation(lying)), 1e-4);
}

TEST_F(TurnSceneTest, WhatStandsAlreadyStaysAndOneLineIsRefused) {
  const auto scene = groomed();
  const SceneSummary before = scene->summary();
  EXPECT_EQ(turn(*scene, {}).revision, before.revision);
  for (const Axis front : {Axis::plus_x, Axis::minus_x})
    EXPECT_EQ(store_->turn(*scene, {.up = Axis::plus_x, .front = front}).status().pointer, "/front");
  EXPECT_EQ(store_->turn(*scene, lying, {.if_match = 77}).status().code, Code::precondition);
  EXPECT_EQ(scene->summary().revision, before.revision);
}

}  // namespace
}  // namespace pelage::turn_scene_test
