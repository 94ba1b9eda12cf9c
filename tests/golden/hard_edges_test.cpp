// Models with hard edges in each tier, one below the other, against golden pictures. After a wanted change run with
// PELAGE_UPDATE_GOLDEN=1, as golden_test.cpp says.
#include <gtest/gtest.h>

#include <array>

#include "renderer/strands/tracer.h"
#include "server/frames/fur_view.h"
#include "server/groom/first_groom.h"
#include "server/patches/subdivide.h"
#include "server/surface/prepare.h"
#include "server/surface/shading_normals.h"
#include "tests/golden/expect_golden.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {
namespace {

/// Builds closed and open shapes with flat faces.
class Shape {
 public:
  Shape& face(std::vector<glm::dvec3> corners) {
    for (const glm::dvec3& p : corners) {
      raw_.corners.push_back(static_cast<std::uint32_t>(raw_.positions.size()));
      raw_.positions.push_back(p);
    }
    raw_.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
    return *this;
  }
  /// Adds the body between two quads with corresponding corners; `from` is clockwise as seen from outside. A quad of
  /// equal corners is a point.
  Shape& loft(const std::array<glm::dvec3, 4>& from, const std::array<glm::dvec3, 4>& to) {
    for (std::size_t k = 0; k < 4; ++k) face({from[k], from[(k + 1) % 4], to[(k + 1) % 4], to[k]});
    return face({from[3], from[2], from[1], from[0]}).face({to[0], to[1], to[2], to[3]});
  }
  const RawModel& raw() const { return raw_; }

 private:
  RawModel raw_;
};

/// Corners of a horizontal rectangle about a point.
std::array<glm::dvec3, 4> level(glm::dvec3 at, double x, double z) {
  return {at + glm::dvec3(-x, 0, z), at + glm::dvec3(x, 0, z), at + glm::dvec3(x, 0, -z), at + glm::dvec3(-x, 0, -z)};
}
/// Corners of an upright rectangle across Z.
std::array<glm::dvec3, 4> upright(glm::dvec3 at, double x, double y) {
  return {at + glm::dvec3(-x, -y, 0), at + glm::dvec3(x, -y, 0), at + glm::dvec3(x, y, 0), at + glm::dvec3(-x, y, 0)};
}

RawModel box(bool lid) {
  Shape shape;
  shape.loft(level({0, -0.5, 0}, 0.5, 0.5), level({0, 0.5, 0}, 0.5, 0.5));
  RawModel raw = shape.raw();
  if (!lid) raw.face_sizes.pop_back(), raw.corners.resize(raw.corners.size() - 4);
  return raw;
}

/// A fox of 13 blocks: body, neck, head, snout, two thin ears, four legs, a tail of two.
RawModel fox() {
  Shape fox;
  fox.loft(upright({0, 1, -1}, 0.3, 0.32), upright({0, 1.05, 0.8}, 0.34, 0.38));
  fox.loft(upright({0, 1.1, 0.6}, 0.2, 0.25), upright({0, 1.7, 1.1}, 0.18, 0.2));
  fox.loft(upright({0, 1.75, 0.8}, 0.3, 0.25), upright({0, 1.75, 1.3}, 0.28, 0.2));
  fox.loft(upright({0, 1.68, 1.25}, 0.16, 0.12), upright({0, 1.62, 1.75}, 0.05, 0.05));
  for (const double side : {-1.0, 1.0}) {
    fox.loft(level({side * 0.2, 1.9, 0.95}, 0.11, 0.03), level({side * 0.26, 2.4, 0.9}, 0.01, 0.01));
    fox.loft(level({side * 0.2, 0, 0.6}, 0.07, 0.1), level({side * 0.2, 1, 0.6}, 0.1, 0.13));
    fox.loft(level({side * 0.2, 0, -0.8}, 0.07, 0.1), level({side * 0.2, 1, -0.75}, 0.11, 0.18));
  }
  fox.loft(upright({0, 1.3, -2.0}, 0.2, 0.2), upright({0, 1.1, -0.95}, 0.1, 0.1));
  fox.loft(upright({0, 1.5, -2.7}, 0.02, 0.02), upright({0, 1.3, -2.0}, 0.2, 0.2));
  return fox.raw();
}

FurredModel subdivided(const FurredModel& model, FirstGroom fur, int levels) {
  Mesh mesh = model.model.surface.mesh();
  PatchMap patches = model.model.patches;
  for (int level = 0; level < levels; ++level) {
    Result<SubdividedSurface> finer =
        subdivide(mesh, patches, {{0, static_cast<std::uint32_t>(mesh.triangles.size())}});
    mesh = std::move(finer->mesh), patches = std::move(finer->patches);
  }
  FieldSet fields = first_groom(mesh, fur);
  return {{Surface(std::move(mesh)), std::move(patches), model.model.id + 1000, "test"}, std::move(fields), {}};
}

/// Traces strands with few passes, filtered. `renderer`, which has the model, draws the backplate.
Image traced(Renderer& renderer, const FurredModel& model, FrameRequest request) {
  const auto never_stop = [] { return true; };
  request.knobs = knobs_of(Tier::reference);
  request.knobs.trace.passes = 16;
  const FurFrame frame = make_frame(model.view(), request);
  const DirtyRange all{0, static_cast<std::uint32_t>(model.fields.size())};
  const ModelArrays arrays = make_arrays(model.view());
  Tracer tracer(2, std::size_t{1} << 30, false);
  Status status = tracer.begin(make_model(model.view(), arrays), make_fields(model.view(), {}, std::span(&all, 1)),
                               frame, renderer.draw_backplate(frame).value(), std::array{Aov::beauty}, never_stop);
  while (status.ok() && tracer.report().end == TraceEnd::none) status = tracer.add_pass(never_stop);
  EXPECT_TRUE(status.ok()) << status.message;
  return renderer.finish(frame, tracer.aov(Aov::beauty)).value();
}

/// Frames of all tiers, one below the other.
Image all_tiers(const FurredModel& model) {
  Renderer renderer{RendererOptions{}};
  FrameRequest request = small_frame(AutoView::three_quarter, 240);
  request.tone_map = ToneMap::filmic, request.background = Background::colour;
  Image strip{240, 0, {}};
  const auto append = [&](const Image& image) {
    strip.height += image.height;
    strip.rgba.insert(strip.rgba.end(), image.rgba.begin(), image.rgba.end());
  };
  for (const Tier tier : {Tier::draft, Tier::interactive, Tier::detailed}) {
    request.knobs = knobs_of(tier);
    append(draw(renderer, model, request));
  }
  append(traced(renderer, model, request));
  return strip;
}

/// Thresholds in 1/255 leave room for the order in which other instruction sets round: mean, half a step; largest, one
/// strand that flips at the edge of a pixel.
void expect_as_looked_at(const FurredModel& model, const std::string& name) {
  constexpr double mean = 0.5;
  constexpr int largest = 60;
  const Image image = all_tiers(model);
  expect_golden(image, name, mean, largest);
}

constexpr FirstGroom short_fur{.length = 0.04};

TEST(HardEdges, OfACube) { expect_as_looked_at(furred(box(true), short_fur), "edges_cube"); }
TEST(HardEdges, OfASubdividedCube) {
  expect_as_looked_at(subdivided(furred(box(true), short_fur), short_fur, 4), "edges_cube_subdivided");
}
/// An open box, prepared as a file's model is.
FurredModel open_box() {
  Mesh mesh = prepare(box(false)).value();
  lean_over_rims(mesh);
  PatchMap patches = lay_patches(mesh);
  FieldSet fields = first_groom(mesh, short_fur);
  return {{Surface(std::move(mesh)), std::move(patches), 2000, "test"}, std::move(fields), {}};
}

TEST(HardEdges, OfAnOpenBox) { expect_as_looked_at(open_box(), "edges_box"); }
TEST(HardEdges, OfALowPolyFox) { expect_as_looked_at(furred(fox(), {.length = 0.025}), "edges_fox"); }

}  // namespace
}  // namespace pelage::testing
