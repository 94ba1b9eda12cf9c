// The knob `min_radius`: what is small on the picture is not drawn smaller still.
#include <cmath>

#include "server/frames/fur_view.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::rendered_scale_test {
namespace {

class RenderedScale : public StoreTest {
 protected:
  /// Of a picture of 512 x 512 pixels, so many sizes of the model away, by knobs of this scale.
  double scale_at(double sizes, double scale, int min_radius, int height = 512) const {
    double result = 0;
    scene_->read([&](const SceneView& view) {
      const Mesh& mesh = view.model.surface.mesh();
      FrameRequest request;
      request.height = height, request.camera.automatic = AutoView::none;
      request.camera.position = mesh.to_model({0, 0, sizes}), request.camera.target = mesh.to_model({0, 0, -1});
      request.knobs.scale = scale, request.knobs.min_radius = min_radius;
      result = make_frame(view, request).knobs.scale;
    });
    return result;
  }

  void SetUp() override {
    StoreTest::SetUp();
    scene_ = make();
  }
  void TearDown() override {
    scene_.reset();
    StoreTest::TearDown();
  }

  std::shared_ptr<Scene> scene_;
};

/// Of a ball of half a size, in pixels of a picture of 512 rows.
double radius_at(double sizes) { return 256 * 0.5 / sizes / std::tan(17.5 * 3.14159265358979 / 180); }

TEST_F(RenderedScale, IsTheKnobWhereTheModelIsLargeEnough) {
  EXPECT_EQ(scale_at(2, 0.6, 120), 0.6) << radius_at(2) * 0.6;
  EXPECT_EQ(scale_at(1e-9, 0.6, 8192), 0.6) << "within the model there is no larger picture of it";
  EXPECT_EQ(scale_at(1000, 0.6, 0), 0.6);
}

TEST_F(RenderedScale, KeepsAModelAtItsLeastRadius) {
  EXPECT_NEAR(scale_at(2.5, 0.6, 120), 120 / radius_at(2.5), 1e-6);
  EXPECT_NEAR(scale_at(2.5, 0.6, 60, 256), 120 / radius_at(2.5), 1e-6) << "the picture's height counts";
  EXPECT_NEAR(scale_at(4, 0.25, 60), 60 / radius_at(4), 1e-6);
}

TEST_F(RenderedScale, IsAtMostOneUnlessTheKnobIsLarger) {
  EXPECT_EQ(scale_at(4, 0.6, 120), 1);
  EXPECT_EQ(scale_at(1e7, 0.25, 1), 1);
  EXPECT_EQ(scale_at(4, 1.5, 8192), 1.5);
}

TEST_F(RenderedScale, WhatWasDrawnDrawsTheSame) {
  const double drawn = scale_at(2.5, 0.6, 120);
  EXPECT_EQ(scale_at(2.5, drawn, 120), drawn);
}

}  // namespace
}  // namespace pelage::rendered_scale_test
