// Draws random scenes with random knobs as shells, rasterized and traced strands. Each picture is finite, or refused
// with a pointer, and it is the same when it is drawn again after another one. More cases:
// RC_PARAMS="max_success=10000" (tests/extremes/fuzz.sh).
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

#include "server/frames/frame_queue.h"
#include "tests/extremes/any_scene.h"
#include "tests/extremes/aov_checker.h"
#include "tests/extremes/row_scene.h"
#include "tests/extremes/with_store.h"

namespace pelage::testing::fuzz_test {
namespace {

using AovImages = std::vector<FloatImage>;

bool same_bits(const AovImages& a, const AovImages& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::memcmp(a[i].rgba.data(), b[i].rgba.data(), a[i].rgba.size() * sizeof(float)) != 0) return false;
  }
  return a.size() == b.size();
}

/// Checks a refusal of members that keep their own limits but together exceed another one.
bool names_what_is_wrong(const Status& refusal) { return !refusal.pointer.empty() && !refusal.limit.empty(); }

/// The request, or nothing if it is refused because members do not go together.
std::optional<FrameRequest> request_or_refusal(const std::string& frame) {
  Row row;
  row.frame = frame;
  const Result<FrameRequest> request = request_of(row);
  if (request) return *request;
  RC_ASSERT(names_what_is_wrong(request.status()));
  return std::nullopt;
}

std::string traced_frame(const std::string& tracing) {
  return R"({"width": 9, "height": 7, "quality": )" + tracing + "}";
}

class Fuzz : public WithRenderer {};

/// Strands per tile. Mesa's software GLs end the loops of a shader after 65,535 iterations in all, and a shader needs
/// one for each segment in 16 x 16 pixels.
constexpr int max_count_by_software_gl = 500;

class Worker {
 public:
  Worker(Renderer& renderer, SceneStore& store, bool with_shells)
      : renderer_(renderer),
        store_(store),
        checker_(renderer, renderer.strands_by_gl() ? max_count_by_software_gl : std::numeric_limits<int>::max()),
        with_shells_(with_shells) {}

  void any_case() {
    const Row row = any_row();
    std::string trail = row.scene + "\n" + row.frame;
    for (const std::string& command : row.commands) trail += "\n" + command;
    const std::string tracing = any_tracing(), other = any_frame();
    RC_LOG() << trail << "\n" << tracing << "\n" << other << "\n";
    const Result<std::shared_ptr<Scene>> scene = scene_of(row, store_);
    if (!scene) {
      if (!names_what_is_wrong(scene.status())) RC_FAIL(scene.status().message + "\n");
      for (const SceneSummary& left : store_.list()) RC_ASSERT(store_.remove(left.id).ok());
      RC_ASSERT(++refused_ <= 3 + cases_ / 10);  // otherwise few of the random scenes are tested
      return;
    }
    look_at(**scene, row.frame, tracing, other);
    renderer_.forget((*scene)->model()->id);
    RC_ASSERT(store_.remove((*scene)->id()).ok());
    if (++cases_ % 10 == 0) std::fprintf(stderr, "%d scenes\n", cases_);  // progress of long runs
  }

 private:
  void look_at(Scene& scene, const std::string& frame, const std::string& tracing, const std::string& other) {
    const std::optional<FrameRequest> asked = request_or_refusal(frame), between = request_or_refusal(other);
    const std::optional<FrameRequest> traced = request_or_refusal(traced_frame(tracing));
    std::optional<AovImages> drawn, strands;
    if (asked) drawn = fine("drawn", draw(scene, *asked));
    if (traced) strands = fine_or_too_many(checker_.trace(scene, *traced));
    if (between) fine("between", draw(scene, *between));
    if (drawn) RC_ASSERT(same_bits(*drawn, *fine("drawn again", draw(scene, *asked))));
    if (strands) RC_ASSERT(same_bits(*strands, *fine("strands", checker_.trace(scene, *traced))));
  }

  /// Draws shells only if `with_shells`, and rasterizes otherwise.
  Result<AovImages> draw(Scene& scene, FrameRequest request) {
    if (request.knobs.method != Method::shells || !with_shells_) request = rasterized(request);
    return checker_.draw(scene, request);
  }

  /// Returns nothing if there are more strands than tracing may take, which is known only after growing them.
  static std::optional<AovImages> fine_or_too_many(Result<AovImages> aovs) {
    if (!aovs && aovs.status().code == Code::too_large && aovs.status().pointer == "/quality/trace/strands") return {};
    return fine("strands", std::move(aovs));
  }

  static std::optional<AovImages> fine(const std::string& method, Result<AovImages> aovs) {
    if (!aovs) RC_FAIL(method + ": " + aovs.status().message + " " + aovs.status().pointer);
    const std::string complaint = complaint_about(*aovs);
    if (!complaint.empty()) RC_FAIL(method + ": " + complaint);
    return std::move(aovs).value();
  }

  Renderer& renderer_;
  SceneStore& store_;
  AovChecker checker_;
  bool with_shells_;
  int cases_ = 0, refused_ = 0;
};

void fuzz(Renderer& renderer, const std::string& folder, const char* unless_asked, bool with_shells) {
  FreshStore store(folder);
  const char* asked = std::getenv("RC_PARAMS");
  if (!asked || !std::strstr(asked, "max_success")) setenv("RC_PARAMS", unless_asked, 1);  // always the same scenes
  Worker worker(renderer, *store, with_shells);
  EXPECT_TRUE(rc::check("any scene", [&] { worker.any_case(); }));
}

TEST_P(Fuzz, AnySceneIsFiniteAndTheSameTwice) {
  fuzz(*renderer, "pelage_fuzz" + std::to_string(static_cast<int>(GetParam())), "max_success=2 seed=1", true);
}

class FuzzOfGlStrands : public OnBackend {};

/// The strand rasterizer of a GPU, on a software GL.
TEST_P(FuzzOfGlStrands, AnySceneIsFiniteAndTheSameTwice) {
  const Result<Renderer*> renderer = stage.strands_renderer(GetParam());
  ASSERT_TRUE(renderer.ok()) << renderer.status().message;
  fuzz(**renderer, "pelage_fuzz_gl_strands" + std::to_string(static_cast<int>(GetParam())), "max_success=2 seed=1",
       false);
}

/// What a server without a GPU draws. It needs no software GL, which would take most of the time.
TEST(FuzzWithoutGl, AnySceneIsFiniteAndTheSameTwice) {
  const Result<std::unique_ptr<Renderer>> renderer = make_renderer(nullptr, 2);
  ASSERT_TRUE(renderer.ok()) << renderer.status().message;
  fuzz(**renderer, "pelage_fuzz_without_gl", "max_success=4 seed=1", false);
}

INSTANTIATE_TEST_SUITE_P(Both, Fuzz, both_backends(), name_of);
INSTANTIATE_TEST_SUITE_P(Both, FuzzOfGlStrands, both_backends(), name_of);

}  // namespace
}  // namespace pelage::testing::fuzz_test
