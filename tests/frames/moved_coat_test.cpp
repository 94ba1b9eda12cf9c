// A coat's pattern, variation and tufts stay attached to a model that has moved: a body turned together with its camera
// and lights looks as before.
#include <memory>

#include "server/frames/fur_view.h"
#include "tests/frames/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage::testing::moved_coat_test {
namespace {

const glm::mat3 quarter(glm::vec3(0, 0, -1), glm::vec3(0, 1, 0), glm::vec3(1, 0, 0));  // a quarter turn about Y

SceneModel copy_of(const SceneModel& model) {
  Mesh mesh = model.surface.mesh();
  return {Surface(std::move(mesh)), model.patches, model.id, model.name};
}

/// The model turned about the vertical axis. Its rest pose is known or not.
FurredModel turned(const FurredModel& rest, bool known) {
  Mesh mesh = rest.model.surface.mesh();
  mesh.centre = glm::dmat3(quarter) * mesh.centre;
  for (glm::vec3& p : mesh.positions) p = quarter * p;
  for (glm::vec3& n : mesh.normals) n = quarter * n;
  for (glm::vec3& t : mesh.tangents) t = quarter * t;
  for (auto& corners : mesh.shading_normals)
    for (glm::vec3& n : corners) n = quarter * n;
  PatchMap patches = rest.model.patches;
  for (PatchPoint& point : patches.points) point.axis = quarter * point.axis;
  FurredModel model{{Surface(std::move(mesh)), std::move(patches), rest.model.id + (known ? 1'000 : 2'000), "turned"},
                    rest.fields,
                    rest.settings};
  for (Light& light : model.settings.lights) light.direction = glm::dmat3(quarter) * light.direction;
  if (known) model.model.rest = std::make_shared<const SceneModel>(copy_of(rest.model));
  return model;
}

FrameRequest seen_from(const glm::dmat3& turn) {
  FrameRequest request = small_frame();
  const glm::dvec3 position(1.1, 0.5, 1.6);
  request.camera = {.automatic = AutoView::none, .position = turn * position, .target = {0, 0, 0}};
  return request;
}

void expect_the_coat_to_go_along(Renderer& renderer, const Coat& coat) {
  FurredModel rest = furred({Builtin::creature, 2000});
  rest.settings.coats[0].coat = coat;
  const Image before = draw(renderer, rest, seen_from(glm::dmat3(1)));
  const Image along = draw(renderer, turned(rest, true), seen_from(glm::dmat3(quarter)));
  const Image in_space = draw(renderer, turned(rest, false), seen_from(glm::dmat3(quarter)));
  EXPECT_GT(covered(before), 0.1);
  const double moved = mean_difference(before, along), swims = mean_difference(before, in_space);
  EXPECT_LT(moved, 2);  // measured 1.7: cells of volumes and light lie differently on the body
  EXPECT_GT(swims, 4);  // measured 6.3
}

std::vector<Coat> coats() {
  Coat spots, varied, tufted;
  spots.pattern.kind = PatternKind::spots;
  varied.variation.lightness = 1, varied.variation.length = 1, varied.variation.lean = 0.5;
  tufted.tufts.gather = 1, tufted.tufts.size = 0.06;
  return {spots, varied, tufted};
}

class MovedCoats : public WithRenderer {};

TEST_F(MovedCoats, GoAlong) {
  for (const Coat& coat : coats()) {
    SCOPED_TRACE(::testing::Message() << coat.tufts.gather << " " << coat.variation.length);
    expect_the_coat_to_go_along(*renderer, coat);
  }
}

}  // namespace
}  // namespace pelage::testing::moved_coat_test
