// The mean picture over a shutter interval while a scene moves.
#include <gtest/gtest.h>

#include <memory>

#include "server/frames/linear_picture.h"

namespace pelage::mean_picture_test {
namespace {

LinearPicture picture(const std::vector<float>& light, const std::vector<float>& depth,
                      const TraceReport& report = {}) {
  LinearPicture picture;
  picture.aovs = {FloatImage{1, 1, light}, FloatImage{1, 1, depth}};
  picture.report = report;
  picture.frame = std::make_shared<const FurFrame>();
  return picture;
}

TEST(MeanPictures, AverageLightAndTakePositionsFromTheMiddleOne) {
  MeanPicture mean({Aov::beauty, Aov::depth}, 3);
  mean.add(picture({1, 0, 1e30f, 1}, {3, 3, 3, 1}));
  LinearPicture second = picture({4, 0, 1e30f, 0}, {5, 5, 5, 1});
  const auto frame = second.frame;
  mean.add(std::move(second));
  mean.add(picture({1, 3, 1e30f, 0.5f}, {7, 7, 7, 1}));
  const LinearPicture taken = std::move(mean).take();
  EXPECT_EQ(taken.aovs[0].rgba, (std::vector<float>{2, 1, 1e30f, 0.5f}));
  EXPECT_EQ(taken.aovs[1].rgba, (std::vector<float>{5, 5, 5, 1}));
  EXPECT_EQ(taken.frame, frame);
}

TEST(MeanPictures, KeepTheLightOfManyDimOnes) {
  MeanPicture mean({Aov::beauty, Aov::alpha}, 256);
  for (int k = 0; k < 256; ++k) mean.add(picture({k == 0 ? 1e6f : 0.1f, 0, 0, 1}, {0, 0, 0, 1}));
  EXPECT_NEAR(std::move(mean).take().aovs[0].rgba[0], (1e6 + 25.5) / 256, 1e-3);
}

TEST(MeanPictures, AreLessNoisyThanTheirParts) {
  MeanPicture mean({Aov::beauty, Aov::depth}, 4);
  for (int k = 0; k < 4; ++k)
    mean.add(picture({0, 0, 0, 0}, {0, 0, 0, 0}, {.passes = 3, .samples = 3, .noise = 0.02, .strands = 10}));
  const TraceReport report = std::move(mean).take().report;
  EXPECT_EQ(report.passes, 12);
  EXPECT_DOUBLE_EQ(report.samples, 12);
  EXPECT_DOUBLE_EQ(report.noise, 0.01);
  EXPECT_EQ(report.strands, 10u);
}

}  // namespace
}  // namespace pelage::mean_picture_test
