// A scene's model in another pose, with its groom and what stands on it.
#include "server/scene/moving_model.h"

#include <glm/gtc/matrix_transform.hpp>

#include "server/builtin/builtin.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::moving_model_test {
namespace {

const glm::dmat3 quarter(glm::rotate(glm::dmat4(1), 1.5707963267948966, glm::dvec3(0, 1, 0)));

class MovingModels : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    scene_ = make(Builtin::creature, 1000);
    raw_ = make_builtin({Builtin::creature, 1000});
  }

  MovingModel moving() const {
    Result<MovingModel> made = store_->moving_model(*scene_);
    EXPECT_TRUE(made.ok()) << made.status().message;
    return std::move(made).value();
  }
  Result<ScenePose> pose(const RawModel& raw) const {
    return moving().pose(raw, scene_->settings()->settings, store_->new_model_id());
  }
  RawModel turned() const {
    RawModel raw = raw_;
    for (glm::dvec3& position : raw.positions) position = quarter * position + glm::dvec3(5, 0, 0);
    return raw;
  }

  std::shared_ptr<Scene> scene_;
  RawModel raw_;
};

TEST_F(MovingModels, AtRestAreWhatTheyWere) {
  execute(*scene_, {comb_at(*scene_, 5)});
  const Result<ScenePose> still = pose(raw_);
  ASSERT_TRUE(still.ok()) << still.status().message;
  const Mesh& rest = scene_->model()->surface.mesh();
  const Mesh& mesh = still->model->surface.mesh();
  EXPECT_EQ(mesh.positions, rest.positions);
  for (std::size_t v = 0; v < rest.normals.size(); ++v) {
    ASSERT_LT(glm::distance(mesh.normals[v], rest.normals[v]), 1e-6f);
    ASSERT_LT(glm::distance(mesh.tangents[v], rest.tangents[v]), 1e-6f);
  }
  EXPECT_NE(still->model->id, scene_->model()->id);
}

TEST_F(MovingModels, TakeEyesCurvesAndSkinAlong) {
  const glm::dvec3 at = vertex_position(*scene_, 100);
  execute(*scene_,
          {SetEyes{{{.position = at, .gaze = {0, 0, 1}}}}, SetCurves{{{.curves = {{at, at + glm::dvec3(0, 1, 0)}}}}},
           SetSkin{{{.centre = at, .radii = {0.1, 0.2, 0.3}, .axis = {0, 0, 1}, .turn_degrees = 30}}}});
  const Result<ScenePose> there = pose(turned());
  ASSERT_TRUE(there.ok()) << there.status().message;
  const glm::dvec3 expected = quarter * at + glm::dvec3(5, 0, 0);
  const double size = scene_->model()->surface.mesh().size;
  const auto near = [&](glm::dvec3 a, glm::dvec3 b) { return glm::distance(a, b) < 1e-3 * size; };
  EXPECT_TRUE(near(there->settings.eyes[0].position, expected));
  EXPECT_TRUE(near(there->settings.eyes[0].gaze * size, glm::dvec3(size, 0, 0)));
  EXPECT_TRUE(near(there->settings.curves[0].curves[0][1], expected + glm::dvec3(0, 1, 0)));
  const SkinRegion& skin = there->settings.skin[0];
  EXPECT_TRUE(near(skin.centre, expected));
  EXPECT_TRUE(near(skin.axis * size, glm::dvec3(size, 0, 0)));
  EXPECT_NEAR(skin.turn_degrees, 30, 0.2);
}

TEST_F(MovingModels, AreSeenByWhoeverDrawsAndNotInTheGroom) {
  const SceneSummary before = scene_->summary();
  Result<ScenePose> there = pose(turned());
  ASSERT_TRUE(there.ok());
  const std::uint64_t id = there->model->id;
  scene_->pose(std::move(*there));
  const SnapshotPtr posed = scene_->snapshot();
  EXPECT_EQ(posed->view().copy_id, id);
  EXPECT_EQ(posed->view().model.id, id);
  const auto touched = posed->changes.since(posed->changes.number() - 1);
  ASSERT_TRUE(touched && touched->size() == 1);
  EXPECT_EQ(touched->front().end, posed->fields->size());
  EXPECT_EQ(scene_->summary().revision, before.revision);
  EXPECT_EQ(scene_->summary().model_id, before.model_id);
  scene_->pose({});
  const std::uint64_t rest = scene_->model()->id;
  EXPECT_EQ(scene_->snapshot()->view().model.id, rest);
}

TEST_F(MovingModels, OfSplitTrianglesMoveToo) {
  ASSERT_TRUE(store_->subdivide(*scene_, {.levels = 1}).ok());
  const Result<ScenePose> there = pose(turned());
  ASSERT_TRUE(there.ok()) << there.status().message;
  const Mesh& rest = scene_->model()->surface.mesh();
  const Mesh& mesh = there->model->surface.mesh();
  ASSERT_EQ(mesh.positions.size(), rest.positions.size());
  for (std::size_t v = 0; v < rest.positions.size(); ++v) {
    const glm::dvec3 expected = quarter * rest.to_model(glm::dvec3(rest.positions[v])) + glm::dvec3(5, 0, 0);
    ASSERT_LT(glm::distance(mesh.to_model(glm::dvec3(mesh.positions[v])), expected), 1e-5 * rest.size);
  }
}

TEST_F(MovingModels, RefuseOtherModels) {
  const MovingModel model = moving();
  const auto pose = [&](const RawModel& raw) { return model.pose(raw, {}, 1); };
  RawModel other = raw_;
  other.positions.emplace_back(0);
  EXPECT_FALSE(pose(other).ok());
  other = raw_;
  std::swap(other.corners[0], other.corners[1]);
  EXPECT_EQ(pose(other).status().code, Code::invalid);
  other = raw_;
  other.positions[7].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(pose(other).status().limit, "1,000 sizes from the model at rest");
  other.positions[7].y = 1e9;
  EXPECT_FALSE(pose(other).ok());
  other = make_builtin({Builtin::creature, 2000});
  EXPECT_FALSE(pose(other).ok());
}

}  // namespace
}  // namespace pelage::moving_model_test
