// A long session: many strokes with undo and redo among them. Then the fields are compared bit for bit with a fresh
// replay and with a restart from the journal. 1,000 strokes, or PELAGE_SOAK_STROKES of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/random.h"
#include "base/stopwatch.h"
#include "server/scene/scene_store.h"

namespace pelage {
namespace {

constexpr int usual_strokes = 1000;
constexpr std::size_t commands_at_a_time = 1000;

/// Resident memory of this process, in MiB.
double resident_megabytes() {
  std::ifstream status("/proc/self/statm");
  double all = 0, resident = 0;
  status >> all >> resident;
  return resident * 4096 / (1 << 20);
}

/// Makes small strokes with the tools that an artist uses most, anywhere on the model.
class Artist {
 public:
  Artist(const Scene& scene, std::uint64_t seed) : random_(seed) {
    const SnapshotPtr now = scene.snapshot();
    const SceneView view = now->view();
    const Mesh& mesh = view.model.surface.mesh();
    size_ = mesh.size;
    for (const glm::vec3 position : mesh.positions) positions_.push_back(mesh.to_model(glm::dvec3(position)));
  }

  Command stroke() {
    switch (below(5)) {
      case 0: return with_stroke(Smooth{.t = 0.5, .passes = 2});
      case 1: return with_stroke(Length{.mode = LengthMode::scale, .value = random_.uniform(0.8, 1.2)});
      case 2: return with_stroke(Paint{.field = Field::wetness, .value = random_.uniform()});
      default: return with_stroke(Comb{.lean = random_.uniform()});
    }
  }
  /// Number of steps to undo now; mostly 0.
  int undone() { return random_.uniform() < 0.1 ? 1 + static_cast<int>(below(5)) : 0; }
  int redone(int undone) { return static_cast<int>(below(static_cast<std::size_t>(undone) + 1)); }

 private:
  std::size_t below(std::size_t count) {
    return std::min(count - 1, static_cast<std::size_t>(random_.uniform(0, static_cast<double>(count))));
  }

  template <class Tool>
  Command with_stroke(Tool tool) {
    Stroke stroke;
    const glm::dvec3 start = positions_[below(positions_.size())];
    const glm::dvec3 step =
        0.02 * size_ * glm::dvec3(random_.uniform(-1, 1), random_.uniform(-1, 1), random_.uniform(-1, 1));
    for (int i = 0; i < 4; ++i) {
      StrokeSample sample;
      sample.position = PositionSample{start + static_cast<double>(i) * step};
      stroke.samples.push_back(sample);
    }
    tool.stroke = stroke;
    tool.brush.radius = random_.uniform(0.02, 0.08), tool.brush.strength = random_.uniform();
    return tool;
  }

  Random random_;
  std::vector<glm::dvec3> positions_;
  double size_ = 1;
};

class Soak : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::remove_all(folder_);
    open();
  }
  void TearDown() override {
    store_.reset();
    std::filesystem::remove_all(folder_);
  }
  void open() {
    store_.reset();
    auto opened = SceneStore::open(folder_.string(), "pelage-import");
    ASSERT_TRUE(opened.ok()) << opened.status().message;
    store_ = std::move(opened).value();
  }
  std::shared_ptr<Scene> make() { return store_->create({"soak", {Builtin::torus, 1000}, {}}).value(); }

  void live(Scene& scene, int strokes) {
    Artist artist(scene, 1);
    const Stopwatch passed;
    for (int done = 1; done <= strokes; ++done) {
      const auto answer = scene.execute({artist.stroke()});
      ASSERT_TRUE(answer.ok()) << answer.status().message << " " << answer.status().pointer;
      if (const int steps = std::min<int>(artist.undone(), static_cast<int>(scene.summary().undo_steps)); steps > 0) {
        ASSERT_TRUE(scene.move(Undo{steps}).ok());
        if (const int again = artist.redone(steps); again > 0) {
          ASSERT_TRUE(scene.move(Redo{again}).ok());
        }
      }
      if (done % std::max(1, strokes / 10) == 0)
        std::printf("%d strokes, %.0f s, %.0f MB\n", done, passed.seconds(), resident_megabytes());
    }
  }

  /// Runs the steps in effect in a fresh scene.
  std::shared_ptr<Scene> replay(const std::vector<std::vector<Command>>& steps) {
    const std::shared_ptr<Scene> fresh = make();
    std::vector<Command> batch;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      batch.insert(batch.end(), steps[i].begin(), steps[i].end());
      if (batch.size() < commands_at_a_time && i + 1 < steps.size()) continue;
      EXPECT_TRUE(fresh->execute(batch).ok());
      batch.clear();
    }
    return fresh;
  }

  std::filesystem::path folder_ = std::filesystem::path(::testing::TempDir()) / "pelage_soak";
  std::unique_ptr<SceneStore> store_;
};

TEST_F(Soak, FieldsAreThoseOfAFreshReplayAndOfARestart) {
  const char* asked = std::getenv("PELAGE_SOAK_STROKES");
  const std::shared_ptr<Scene> scene = make();
  live(*scene, asked ? std::atoi(asked) : usual_strokes);
  const FieldsHash hash = scene->summary().fields_hash;
  const auto steps = scene->effective_log();
  EXPECT_FALSE(steps.empty());
  EXPECT_NE(hash, make()->summary().fields_hash);
  EXPECT_EQ(replay(steps)->summary().fields_hash, hash);
  std::printf("%zu steps in effect, replayed to the same fields\n", steps.size());
  const std::string id = scene->id();
  open();
  EXPECT_EQ(store_->find(id).value()->summary().fields_hash, hash);
}

}  // namespace
}  // namespace pelage
