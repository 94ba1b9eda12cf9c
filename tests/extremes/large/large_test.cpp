// The largest picture and the largest model. They take gigabytes and minutes of software GL, so they run by hand:
// tests/extremes/large.sh.
#include <gtest/gtest.h>

#include <memory>

#include "tests/extremes/aov_checker.h"
#include "tests/extremes/row_scene.h"
#include "tests/extremes/with_store.h"

namespace pelage::testing {
namespace {

class Large : public WithRenderer {
 protected:
  FreshStore store_{"pelage_large" + std::to_string(static_cast<int>(GetParam()))};
};

TEST_P(Large, APictureOf8192IsDrawnAndRefusedToTracing) {
  const Row row{.area = "camera",
                .value = "8192 x 8192",
                .frame = R"({"width": 8192, "height": 8192, "quality": {"method": "shells", "shells": {"count": 1}}})"};
  const std::shared_ptr<Scene> scene = scene_of(row, *store_).value();
  AovChecker checker(*renderer);
  FrameRequest request = request_of(row).value();
  for (const FrameRequest& drawn : {request, rasterized(request)}) {
    const Result<Image> image = checker.show(*scene, drawn);
    ASSERT_TRUE(image.ok()) << image.status().message;
    for (std::size_t i = 3; i < image->rgba.size(); i += 4) ASSERT_EQ(image->rgba[i], 255);
  }
  request.knobs.method = Method::strands;
  const auto traced = checker.trace(*scene, request);
  ASSERT_FALSE(traced.ok());
  EXPECT_EQ(traced.status().code, Code::too_large);
  EXPECT_EQ(traced.status().pointer, "/width");
}

TEST_P(Large, AModelOfAMillionTriangles) {
  const Row row{.area = "mesh",
                .value = "1,000,000 triangles",
                .scene = R"({"model": {"builtin": "torus", "triangles": 1000000}, "fur": {"length": 0.05}})"};
  const std::shared_ptr<Scene> scene = scene_of(row, *store_).value();
  EXPECT_GT(scene->model()->surface.mesh().triangles.size(), 990'000u);
  AovChecker checker(*renderer);
  std::string complaint;
  const Status status = checker.look_at(*scene, request_of(row).value(), complaint);
  EXPECT_TRUE(status.ok()) << status.message;
  EXPECT_EQ(complaint, "");
}

INSTANTIATE_TEST_SUITE_P(Both, Large, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing
