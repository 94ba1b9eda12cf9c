// Fragments sorted in each pixel: stacks whose picture is known, and frames.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "renderer/shells/draw/draw.h"
#include "renderer/shells/sorted/sorted_pass.h"
#include "server/frames/fur_view.h"
#include "server/patches/patches.h"
#include "tests/gl/with_renderer.h"
#include "tests/support/furred_model.h"

namespace pelage {
namespace shaders {
extern const char* const stack_vert;
extern const char* const stack_frag;
}  // namespace shaders

namespace testing::sorted_test {
namespace {

struct Quad {
  float depth = 0.5f, grey = 1, opacity = 0.5f, padding = 0;
};

/// Light and alpha of quads of different depths, composited over black in double.
glm::dvec2 composite(std::vector<Quad> quads) {
  std::sort(quads.begin(), quads.end(), [](const Quad& a, const Quad& b) { return a.depth > b.depth; });
  double light = 0, left = 1;
  for (const Quad& quad : quads) {
    light += left * double{quad.opacity} * double{quad.grey};
    left *= 1 - double{quad.opacity};
  }
  return {light, 1 - left};
}

/// `count` quads with distinct depths, in random order.
std::vector<Quad> random_stack(int count, float opacity) {
  std::mt19937 random(7);
  std::vector<Quad> quads;
  for (int i = 0; i < count; ++i) {
    const float grey = static_cast<float>(random() % 1000) / 1000;
    quads.push_back({0.1f + 0.8f * static_cast<float>(i) / static_cast<float>(count), grey, opacity, 0});
  }
  std::shuffle(quads.begin(), quads.end(), random);
  return quads;
}

class Stack : public OnBackend {
 protected:
  static constexpr int side = 8;

  struct Drawn {
    Status status;
    std::vector<float> rgba;
    int areas = 0;
  };

  /// What the sorting pass makes of quads alone, with `behind` in the depth buffer.
  Drawn sorted(const std::vector<Quad>& quads, std::size_t bytes = 1 << 22, float behind = 0) {
    const RenderTarget target(gl(), GL_RGBA32F, side, side, true);
    set_draw_state(gl(), target);
    gl().DepthMask(GL_TRUE);
    clear_target(gl(), target, {});
    gl().ClearNamedFramebufferfv(target.framebuffer(), GL_DEPTH, 0, &behind);
    const Program program(gl(), shaders::stack_vert, shaders::stack_frag, "#define SORTED\n");
    EXPECT_EQ(program.log(), "");
    const Buffer buffer(gl()), elements(gl());
    const VertexArray array(gl());
    const std::array<GLuint, 4> order{0, 1, 2, 3};
    gl().NamedBufferData(buffer.id(), static_cast<GLsizeiptr>(quads.size() * sizeof(Quad)), quads.data(),
                         GL_STATIC_DRAW);
    gl().NamedBufferData(elements.id(), sizeof(order), order.data(), GL_STATIC_DRAW);
    gl().VertexArrayElementBuffer(array.id(), elements.id());
    gl().BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer.id());
    SortedPass pass(gl(), bytes);
    Drawn drawn;
    drawn.status = pass.draw(gl(), target, {0, 0, target.width(), target.height()}, 1, [&] {
      ++drawn.areas;
      program.use();
      gl().BindVertexArray(array.id());
      gl().DrawElementsInstanced(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(quads.size()));
    });
    EXPECT_EQ(pass.failure(), "");
    drawn.rgba.resize(4 * side * side);
    gl().BindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
    gl().ReadPixels(0, 0, side, side, GL_RGBA, GL_FLOAT, drawn.rgba.data());
    return drawn;
  }

  static void expect_everywhere(const Drawn& drawn, glm::dvec2 wanted, double tolerance) {
    ASSERT_TRUE(drawn.status.ok()) << drawn.status.message;
    for (std::size_t i = 0; i < drawn.rgba.size(); i += 4) {
      ASSERT_NEAR(drawn.rgba[i], wanted.x, tolerance) << "pixel " << i / 4;
      ASSERT_NEAR(drawn.rgba[i + 3], wanted.y, tolerance) << "pixel " << i / 4;
    }
  }
};

TEST_P(Stack, ThreeQuadsByHand) {
  // Nearest first: .5 of 1, then .5 of the .5 that is left of .2, then .5 of .25 of .4.
  const std::vector<Quad> quads{{0.2f, 0.4f, 0.5f}, {0.8f, 1, 0.5f}, {0.5f, 0.2f, 0.5f}};
  expect_everywhere(sorted(quads), {0.5 + 0.25 * 0.2 + 0.125 * 0.4, 0.875}, 1e-6);
}

TEST_P(Stack, AnyNumberInAnyOrder) {
  for (const int count : {1, 2, 3, 17, 256, 5000}) {
    const std::vector<Quad> quads = random_stack(count, 2.0f / static_cast<float>(count + 2));
    expect_everywhere(sorted(quads, std::size_t{1} << 25), composite(quads), 2e-5);
  }
}

TEST_P(Stack, FromFarToNearAndBack) {
  std::vector<Quad> quads = random_stack(3000, 0.001f);
  std::sort(quads.begin(), quads.end(), [](const Quad& a, const Quad& b) { return a.depth < b.depth; });
  expect_everywhere(sorted(quads), composite(quads), 2e-5);
  std::reverse(quads.begin(), quads.end());
  expect_everywhere(sorted(quads), composite(quads), 2e-5);
}

TEST_P(Stack, WhatIsHiddenIsNotInTheList) {
  const std::vector<Quad> quads = random_stack(100, 0.05f);
  std::vector<Quad> seen;
  std::copy_if(quads.begin(), quads.end(), std::back_inserter(seen), [](const Quad& q) { return q.depth >= 0.5f; });
  expect_everywhere(sorted(quads, 1 << 22, 0.5f), composite(seen), 1e-5);
}

TEST_P(Stack, EqualDepthsAreAMixture) {
  std::vector<Quad> quads{{0.5f, 1, 0.5f}, {0.5f, 0, 0.25f}, {0.3f, 0.8f, 0.5f}};
  const double opacity = 1 - 0.5 * 0.75, grey = 0.5 / 0.75;
  const glm::dvec2 wanted{opacity * grey + (1 - opacity) * 0.5 * 0.8, 1 - (1 - opacity) * 0.5};
  expect_everywhere(sorted(quads), wanted, 1e-6);
  std::reverse(quads.begin(), quads.end());
  expect_everywhere(sorted(quads), wanted, 1e-6);
}

TEST_P(Stack, LittleMemoryTakesMoreAreas) {
  const std::vector<Quad> quads = random_stack(100, 0.02f);
  const Drawn whole = sorted(quads);
  const Drawn tiny = sorted(quads, 150 * FragmentLists::fragment_bytes);  // room for one and a half pixels
  EXPECT_EQ(whole.areas, 1);
  EXPECT_GE(tiny.areas, side * side);
  ASSERT_TRUE(tiny.status.ok());
  EXPECT_EQ(tiny.rgba, whole.rgba);
  // Room for exactly all of them is enough, and one less is not.
  const std::size_t all = 100 * side * side * FragmentLists::fragment_bytes;
  EXPECT_EQ(sorted(quads, all).areas, 1);
  EXPECT_EQ(sorted(quads, all - FragmentLists::fragment_bytes).areas, 3);
}

TEST_P(Stack, APixelThatDoesNotFitIsRefused) {
  const Drawn drawn = sorted(random_stack(100, 0.02f), 99 * FragmentLists::fragment_bytes);
  EXPECT_EQ(drawn.status.code, Code::too_large);
  EXPECT_EQ(drawn.status.pointer, "/quality/order");
}

TEST_P(Stack, AListThatIsTooLongIsRefused) {
  const Drawn drawn = sorted(random_stack(61'000, 1e-5f), std::size_t{128} << 20);
  EXPECT_EQ(drawn.status.code, Code::too_large);
  EXPECT_EQ(drawn.status.pointer, "/quality/order");
}

TEST_P(Stack, WithoutBuffersInFragmentShadersItIsRefused) {
  Gl without = gl();
  without.GetIntegerv = [](GLenum, GLint* value) { *value = 0; };
  const RenderTarget target(gl(), GL_RGBA32F, side, side, true);
  SortedPass pass(without, 1 << 20);
  const Status status = pass.draw(without, target, {}, 1, [] { FAIL() << "must not draw"; });
  EXPECT_EQ(status.code, Code::invalid);
  EXPECT_EQ(status.pointer, "/quality/order");
}

INSTANTIATE_TEST_SUITE_P(Gl, Stack, both_backends(), name_of);

class Sorted : public WithRenderer {
 protected:
  FloatImage light_of(Renderer& with, const FurredModel& model, const FrameRequest& request,
                      DrawTimes* times = nullptr) {
    sync_shells(with, model, {VertexRange{0, static_cast<std::uint32_t>(model.fields.size())}});
    const FurFrame frame = make_frame(model.view(), request);
    Result<std::vector<FloatImage>> images = with.draw_aovs(frame, std::array{Aov::beauty}, times);
    EXPECT_TRUE(images.ok()) << images.status().message;
    with.forget(model.model.id);
    return std::move(images.value().front());
  }

  static FrameRequest request_of(FragmentOrder order, int shells, int size = 64) {
    FrameRequest request = shells_frame(AutoView::three_quarter, size);
    request.knobs.shells.order = order;
    request.knobs.shells.count = shells;
    request.knobs.shells.policy = ShellPolicy::uniform;
    return request;
  }

  static double apart(const FloatImage& a, const FloatImage& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(double{a.rgba[i]} - double{b.rgba[i]});
    return sum / static_cast<double>(a.rgba.size());
  }

  static double largest(const FloatImage& a, const FloatImage& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
      worst = std::max(worst, std::abs(double{a.rgba[i]} - double{b.rgba[i]}));
    return worst;
  }
};

TEST_P(Sorted, OrderOfTrianglesDoesNotMatter) {
  FurredModel model = furred({Builtin::torus, 1000}, {.length = 0.05, .inclination = 0.5});
  const FrameRequest request = request_of(FragmentOrder::sorted, 16);
  const FloatImage before = light_of(*renderer, model, request);
  FrameRequest aovs = request;
  aovs.knobs.shells.order = FragmentOrder::four_pass;
  const FloatImage aovs_before = light_of(*renderer, model, aovs);
  std::reverse(model.model.patches.patch_triangles.begin(), model.model.patches.patch_triangles.end());
  EXPECT_LT(largest(before, light_of(*renderer, model, request)), 1e-5);
  EXPECT_GT(largest(aovs_before, light_of(*renderer, model, aovs)), 1e-3);  // the order did change
}

TEST_P(Sorted, IsWhatShellsAreOnOneConvexPartSeenHeadOn) {
  FurredModel model = furred({Builtin::plane, 2}, {.length = 0.05, .inclination = 0.2});
  model.model.patches = with_hard_borders(model.model.patches);  // so that no two fragments have the same depth
  FrameRequest request = request_of(FragmentOrder::sorted, 64);
  request.camera.automatic = AutoView::top;
  const FloatImage sorted = light_of(*renderer, model, request);
  request.knobs.shells.order = FragmentOrder::four_pass;
  const FloatImage aovs = light_of(*renderer, model, request);
  double seen = 0;
  for (std::size_t i = 3; i < aovs.rgba.size(); i += 4) seen += double{aovs.rgba[i]};
  EXPECT_GT(seen, 500);
  EXPECT_LT(largest(sorted, aovs), 1e-3);  // shells skip what lies well below dense fur
}

TEST_P(Sorted, TinyMemoryGivesTheSamePicture) {
  const FurredModel model = furred({Builtin::torus, 1000}, {.length = 0.05, .inclination = 0.5});
  const FrameRequest request = request_of(FragmentOrder::sorted, 32);
  DrawTimes whole, parts;
  const FloatImage wanted = light_of(*renderer, model, request, &whole);
  Result<std::unique_ptr<Renderer>> small =
      Renderer::create(gl(), {.sorted_bytes = 4000 * FragmentLists::fragment_bytes});
  ASSERT_TRUE(small.ok());
  const FloatImage image = light_of(**small, model, request, &parts);
  EXPECT_GT(parts.counters.draws, 8 * whole.counters.draws);
  EXPECT_LT(largest(wanted, image), 1e-6);
}

TEST_P(Sorted, ThousandShellsComeCloserToEachOther) {
  const FurredModel model = furred({Builtin::torus, 1000}, {.length = 0.05, .inclination = 0.5});
  const FloatImage few = light_of(*renderer, model, request_of(FragmentOrder::sorted, 64, 32));
  const FloatImage more = light_of(*renderer, model, request_of(FragmentOrder::sorted, 256, 32));
  const FloatImage max = light_of(*renderer, model, request_of(FragmentOrder::sorted, 1024, 32));
  EXPECT_LT(apart(more, max), 0.5 * apart(few, max));
}

INSTANTIATE_TEST_SUITE_P(Gl, Sorted, both_backends(), name_of);

}  // namespace
}  // namespace testing::sorted_test
}  // namespace pelage
