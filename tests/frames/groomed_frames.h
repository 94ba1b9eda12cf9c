// A fixture that draws a groomed model again after each stroke, and compares it with a frame that is drawn whole.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <vector>

#include "server/frames/fur_view.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {

class GroomedFrames : public ::testing::Test {
 protected:
  struct Drawn {
    Image image;
    double redrawn = 0;  // share of the picture that was drawn again, [0, 1]
  };

  /// The frame of the model, after `drawer` has been updated to the model's current state.
  template <class Drawer>
  FurFrame frame_for(Drawer& drawer, const FurredModel& model, const std::vector<DirtyRange>& dirty) {
    FurFrame frame = make_frame(model.view(), request);
    const ModelArrays arrays = make_arrays(model.view());
    const FurModel fur = make_model(model.view(), arrays);
    const std::vector<FurFields> fields = make_fields(model.view(), frame.skin, dirty);
    if (known.insert(fur.id).second) drawer.add(fur, fields);
    drawer.update(fur.id, fields);
    return frame;
  }

  /// Changes fur and paint around a random vertex. Returns the vertices that changed.
  std::vector<DirtyRange> stroke(FurredModel& model) {
    const Mesh& mesh = model.model.surface.mesh();
    const auto any = [&](float high) { return std::uniform_real_distribution<float>(0, high)(random); };
    const glm::vec3 middle = mesh.positions[random() % mesh.positions.size()];
    std::vector<DirtyRange> dirty;
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
      if (glm::distance(mesh.positions[v], middle) > 0.1f) continue;
      model.fields.set(Field::direction, v, {any(0.7f), any(0.7f), 0, 0});
      model.fields.set(Field::length, v, {any(0.12f), 0, 0, 0});
      model.fields.set(Field::tip_colour, v, {any(1), any(1), any(1), 1});
      dirty.push_back({v, v + 1});
    }
    return dirty;
  }

  /// An animal with an eye, whiskers and a ground.
  static FurredModel animal() {
    FurredModel model = coarse(furred({Builtin::creature, 2000}));
    model.settings.ground.visible = true;
    model.settings.eyes = {Eye{}};
    CurveGroup group;
    group.width_root = 0.01, group.fill = 5, group.spread = 1;
    const Mesh& mesh = model.model.surface.mesh();
    for (std::size_t v = 0; v < 200; v += 40) {
      const glm::dvec3 root = glm::dvec3(mesh.positions[v]) * mesh.size + mesh.centre,
                       normal = glm::dvec3(mesh.normals[v]) * mesh.size;
      group.curves.push_back({root, root + 0.03 * normal, root + 0.04 * normal + glm::dvec3(0.2, 0, 0.1) * mesh.size});
    }
    model.settings.curves = {group};
    return model;
  }

  /// Draws the frame after changes; draws it whole after forget_views.
  virtual Drawn draw_after(const FurredModel& model, const std::vector<DirtyRange>& dirty) = 0;
  virtual void forget_views() = 0;

  Image whole(const FurredModel& model) {
    forget_views();
    const Drawn drawn_whole = draw_after(model, {});
    EXPECT_EQ(drawn_whole.redrawn, 1);
    return drawn_whole.image;
  }

  /// Draws after each of some strokes, and compares with a frame that is drawn whole. Returns the smallest share of the
  /// picture that a stroke redrew.
  double expect_same_bits(FurredModel& model, int strokes = 3) {
    draw_after(model, stroke(model));  // from here on the model is painted
    double smallest = 1;
    for (int i = 0; i < strokes; ++i) {
      const Drawn part = draw_after(model, stroke(model));
      EXPECT_EQ(part.image.rgba, whole(model).rgba) << "stroke " << i << ", " << part.redrawn << " of the picture";
      smallest = std::min(smallest, part.redrawn);
    }
    return smallest;
  }

  std::set<std::uint64_t> known;
  FrameRequest request = small_frame(AutoView::three_quarter, 192);
  std::mt19937 random{7};
};

}  // namespace pelage::testing
