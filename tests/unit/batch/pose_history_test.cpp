// The acceleration that a moving model's fur feels.
#include "server/batch/pose_history.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "protocol/json/decode.h"
#include "server/batch/job_scene.h"
#include "server/builtin/builtin.h"

namespace pelage::pose_history_test {
namespace {

constexpr double fps = 24;

/// A sphere that is moved by a function of the time in seconds; it exists from frame `first` on.
class PoseHistoryTest : public ::testing::Test {
 protected:
  template <typename Move>
  PoseHistory history(const Move& move, double strength = 1, int first = -1000) {
    const auto name = [first](int frame) -> Result<std::string> {
      return frame < first ? std::string() : std::to_string(frame);
    };
    const auto load = [this, move](int frame) -> Result<RawModel> {
      ++loads_;
      RawModel raw = make_builtin(shape_);
      for (glm::dvec3& position : raw.positions) position = move(position, frame / fps);
      return raw;
    };
    return PoseHistory(model_, fps, strength, {name, load});
  }

  BuiltinModel shape_{Builtin::sphere, 200};
  JobScene scene_ = [] {
    RenderJob job;
    job.builtin = BuiltinModel{Builtin::sphere, 200};
    return std::move(JobScene::open(job, ".")).value();
  }();
  MovingModel model_ = std::move(scene_.moving_model()).value();
  double size_ = scene_.scene()->model()->surface.mesh().size;
  int loads_ = 0;
};

TEST_F(PoseHistoryTest, EvenMotionHasNoAcceleration) {
  auto even = history([](glm::dvec3 p, double t) { return p + t * glm::dvec3(1, 2, 3); });
  const auto swing = even.at(30, 1.25);
  ASSERT_TRUE(swing.ok()) << swing.status().message;
  for (const double t : {1.25, 1.0, -2.0}) EXPECT_LT(glm::length(swing->acceleration(7, t)), 2e-3);
}

TEST_F(PoseHistoryTest, AFallHasItsAcceleration) {
  auto fall = history([](glm::dvec3 p, double t) { return p - 0.5 * t * t * glm::dvec3(0, 3, 0); }, 2);
  const auto swing = fall.at(30, 100.25);  // the scene's time need not be that of the frame
  ASSERT_TRUE(swing.ok());
  for (const double back : {0.0, 0.33, 2.0})
    EXPECT_LT(glm::distance(swing->acceleration(7, 100.25 - back), glm::dvec3(0, -6 / size_, 0)), 0.02 / size_);
  EXPECT_EQ(swing->step, 1 / fps);
}

TEST_F(PoseHistoryTest, OfATurnPointsOutOfTheSkinAsItDidThen) {
  constexpr double rate = 2;
  auto turn = history(
      [](glm::dvec3 p, double t) { return glm::dmat3(glm::rotate(glm::dmat4(1), rate * t, glm::dvec3(0, 1, 0))) * p; });
  const auto swing = turn.at(24, 1);
  ASSERT_TRUE(swing.ok());
  const Mesh now = std::move(model_.mesh([&] {
                     RawModel raw = make_builtin(shape_);
                     for (glm::dvec3& p : raw.positions)
                       p = glm::dmat3(glm::rotate(glm::dmat4(1), rate, glm::dvec3(0, 1, 0))) * p;
                     return raw;
                   }()))
                       .value();
  for (std::uint32_t v = 0; v < now.positions.size(); v += 7) {
    const glm::dvec3 position = now.to_model(glm::dvec3(now.positions[v])) / size_;
    const glm::dvec3 inwards = -rate * rate * glm::dvec3(position.x, 0, position.z);
    for (const double t : {1.0, 0.2})  // in the body's current coordinates, at any earlier time
      ASSERT_LT(glm::distance(swing->acceleration(v, t), inwards), 0.02) << v;
  }
}

TEST_F(PoseHistoryTest, BeginsWithTheFirstFileAndLoadsEachOnce) {
  auto late = history([](glm::dvec3 p, double t) { return p + t * t * glm::dvec3(1, 0, 0); }, 1, 10);
  const auto swing = late.at(12, 0.5);
  ASSERT_TRUE(swing.ok());
  EXPECT_EQ(swing->acceleration(3, 10 / fps), glm::dvec3(0));
  EXPECT_GT(glm::length(swing->acceleration(3, 11.5 / fps)), 0.5);
  const int before = loads_;
  ASSERT_TRUE(late.at(13, 13 / fps).ok());
  EXPECT_EQ(loads_, before + 1);
}

}  // namespace
}  // namespace pelage::pose_history_test
