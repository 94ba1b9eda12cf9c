// A fixture with a scene store in a temporary folder, and commands for its scenes.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "server/scene/scene_store.h"

namespace pelage {

class StoreTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("pelage_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::remove_all(folder_);
    open();
  }
  void TearDown() override {
    store_.reset();
    std::filesystem::remove_all(folder_);
  }

  void open(std::size_t undo_bytes = limits::undo_bytes, std::size_t memory = std::numeric_limits<std::size_t>::max()) {
    store_.reset();
    auto store = SceneStore::open(folder_.string(), "pelage-import", undo_bytes, memory);
    ASSERT_TRUE(store.ok()) << store.status().message;
    store_ = std::move(*store);
  }

  std::shared_ptr<Scene> make(Builtin shape = Builtin::torus, int triangles = 1000) const {
    const auto scene = store_->create({"test", {shape, triangles}, {}});
    EXPECT_TRUE(scene.ok()) << scene.status().message;
    return scene.ok() ? *scene : nullptr;
  }

  static FieldsHash hash(const Scene& scene) { return scene.summary().fields_hash; }

  /// A vertex's position in model coordinates.
  static glm::dvec3 vertex_position(const Scene& scene, std::size_t vertex) {
    glm::dvec3 found{};
    const SnapshotPtr now = scene.snapshot();
    const SceneView view = now->view();
    const Mesh& mesh = view.model.surface.mesh();
    found = mesh.to_model(glm::dvec3(mesh.positions[vertex % mesh.positions.size()]));
    return found;
  }

  /// A stroke of `samples` straight samples that starts at a vertex.
  static Stroke stroke_at(const Scene& scene, std::size_t vertex, std::size_t samples = 4) {
    Stroke stroke;
    const double size = scene.summary().report.size;
    for (std::size_t i = 0; i < samples; ++i) {
      StrokeSample sample;
      const double along = 0.1 * size * static_cast<double>(i) / static_cast<double>(samples);
      sample.position = PositionSample{vertex_position(scene, vertex) + glm::dvec3(along, 0.5 * along, -0.3 * along)};
      stroke.samples.push_back(sample);
    }
    return stroke;
  }
  static Comb comb_at(const Scene& scene, std::size_t vertex) {
    Comb comb;
    comb.stroke = stroke_at(scene, vertex);
    comb.brush.radius = 0.08;
    return comb;
  }
  static Comb comb_nothing(const Scene& scene) {
    Comb comb = comb_at(scene, 0);
    for (StrokeSample& sample : comb.stroke->samples) std::get<PositionSample>(sample.position).position += 1000.0;
    return comb;
  }

  static CommandAnswer execute(Scene& scene, const std::vector<Command>& commands, const ExecuteOptions& options = {}) {
    const Result<CommandAnswer> answer = scene.execute(commands, options);
    EXPECT_TRUE(answer.ok()) << answer.status().message << " " << answer.status().pointer;
    return answer.ok() ? *answer : CommandAnswer{};
  }
  static CommandAnswer move(Scene& scene, const HistoryMove& move) {
    const Result<CommandAnswer> answer = scene.move(move);
    EXPECT_TRUE(answer.ok()) << answer.status().message;
    return answer.ok() ? *answer : CommandAnswer{};
  }

  std::filesystem::path folder_;
  std::unique_ptr<SceneStore> store_;
};

}  // namespace pelage
