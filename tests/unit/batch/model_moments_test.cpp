// Which file holds a job's model at a frame.
#include "server/batch/model_moments.h"

#include <gtest/gtest.h>

#include <fstream>

#include "server/export/temporary_folder.h"

namespace pelage::model_moments_test {
namespace {

class ModelMomentsTest : public ::testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) const { std::ofstream(folder_.file(name)) << bytes; }
  Result<ModelMoments> made(const JobMotion& motion) const {
    return ModelMoments::create(motion, 24, folder_.file(""));
  }

  TemporaryFolder folder_ = std::move(TemporaryFolder::make()).value();
};

TEST_F(ModelMomentsTest, OfNumberedFilesAreTheFramesOwn) {
  write("walk.007.obj", "seven"), write("walk.008.obj", "eight"), write("walk.009.obj", "seven");
  const auto moments = made({.model = "walk.###.obj", .animation = {}, .loop_seconds = {}});
  ASSERT_TRUE(moments.ok()) << moments.status().message;
  const auto seven = moments->at(7);
  ASSERT_TRUE(seven.ok()) << seven.status().message;
  EXPECT_EQ(seven->file, folder_.file("walk.007.obj"));
  EXPECT_EQ(seven->format, ModelFormat::obj);
  EXPECT_EQ(seven->pose, "");
  EXPECT_NE(moments->at(8)->digest, seven->digest);
  EXPECT_EQ(moments->at(9)->digest, seven->digest);
  const auto missing = moments->at(10);
  EXPECT_EQ(missing.status().code, Code::not_found);
  EXPECT_EQ(missing.status().pointer, "/motion/model");
}

TEST_F(ModelMomentsTest, AreInterpolatedBetweenTwoFiles) {
  write("walk.1.obj", "one"), write("walk.2.obj", "two");
  const auto moments = made({.model = "walk.#.obj", .animation = {}, .loop_seconds = {}});
  const auto between = moments->at(1.25);
  EXPECT_EQ(between->file, folder_.file("walk.1.obj"));
  EXPECT_EQ(between->next, folder_.file("walk.2.obj"));
  EXPECT_DOUBLE_EQ(between->share, 0.25);
  EXPECT_NE(between->digest, moments->at(1.5)->digest);
  for (const double still : {0.75, 1.0, 2.25}) EXPECT_EQ(moments->at(still)->next, "") << still;
  EXPECT_EQ(moments->at(0.75)->digest, moments->at(1)->digest);
  EXPECT_EQ(moments->at(2.25)->digest, moments->at(2)->digest);
  EXPECT_EQ(moments->at(0.25).status().code, Code::not_found);
}

TEST_F(ModelMomentsTest, OfAnAnimationGoByTheSecondAndBeginAgain) {
  write("fox.glb", "bytes");
  const auto once = made({.model = "fox.glb", .animation = "Walk", .loop_seconds = {}});
  ASSERT_TRUE(once.ok()) << once.status().message;
  EXPECT_EQ(once->at(36)->pose, "Walk@1.500000");
  EXPECT_EQ(once->at(35.76)->pose, "Walk@1.490000");
  EXPECT_EQ(once->at(-3)->pose, "Walk@0.000000");
  const auto again = made({.model = "fox.glb", .animation = "Walk", .loop_seconds = 0.5});
  EXPECT_EQ(again->at(6)->pose, "Walk@0.250000");
  EXPECT_EQ(again->at(18)->pose, "Walk@0.250000");
  EXPECT_EQ(again->at(-6)->pose, "Walk@0.250000");
  EXPECT_EQ(again->at(6)->digest, once->at(36)->digest);
  const auto seventeen = made({.model = "fox.glb", .animation = "Walk", .loop_seconds = 0.7083333});
  EXPECT_EQ(*seventeen->name_of(3), *seventeen->name_of(3 + 17 * 5));
}

TEST_F(ModelMomentsTest, AreRefusedWhereNothingMoves) {
  EXPECT_EQ(made({.model = "fox.glb", .animation = {}, .loop_seconds = {}}).status().pointer, "/motion");
  EXPECT_EQ(made({.model = "f.#.glb", .animation = "Walk", .loop_seconds = {}}).status().pointer, "/motion/animation");
  EXPECT_EQ(made({.model = "f.#.glb", .animation = {}, .loop_seconds = 1}).status().pointer, "/motion/loop_seconds");
  EXPECT_EQ(made({.model = "f.#.blend", .animation = {}, .loop_seconds = {}}).status().pointer, "/motion/model");
  EXPECT_EQ(made({.model = "f.#.#.obj", .animation = {}, .loop_seconds = {}}).status().limit, "one run of #");
}

}  // namespace
}  // namespace pelage::model_moments_test
