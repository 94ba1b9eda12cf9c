// Unused features cost nothing in shells: a feature that is named and not used asks nothing of the GL, and one that was
// used and taken away leaves nothing behind.
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <ostream>

#include "renderer/frame/renderer.h"
#include "server/frames/fur_view.h"
#include "tests/extremes/features.h"
#include "tests/extremes/row_scene.h"
#include "tests/extremes/with_store.h"

namespace pelage {

// Lets GoogleTest print counters that differ.
void PrintTo(const FrameCounters& counters, std::ostream* out) {
  *out << counters.passes << " passes, " << counters.draws << " draws, " << counters.textures << " textures, "
       << counters.bytes << " bytes, " << counters.fragments << " fragments, " << counters.objects << " objects, "
       << counters.allocated << " allocated";
}

namespace testing {
namespace {

class Needs : public WithRenderer {
 protected:
  void SetUp() override {
    WithRenderer::SetUp();
    if (!renderer) return;
    scene_ = scene_of({.area = "needs", .value = "plain"}, *store_).value();
    execute(R"({"op": "set_look", "look": {"shading": "kajiya"}})");  // needs no table
    execute(R"({"op": "set_coat", "coat": {)" + few_strands + "}}");
  }

  static FrameRequest request(const std::string& members) {
    const std::string quality =
        members.find("quality") == std::string::npos ? R"("quality": {"method": "shells"})" : "";
    std::string frame = R"({"width": 48, "height": 32)";
    for (const std::string& more : {quality, members}) frame += more.empty() ? more : ", " + more;
    return request_of({.area = "", .value = "", .frame = frame + "}"}).value();
  }

  FrameCounters drawn(const FrameRequest& request) {
    const SnapshotPtr now = scene_->snapshot();
    const auto touched = drawn_ ? now->changes.since(*drawn_) : std::nullopt;
    sync_scene(*renderer, now->view(), touched.value_or(full_vertex_range(now->fields->size())), nullptr, true);
    drawn_ = now->changes.number();
    const FurFrame frame = make_frame(now->view(), request);
    DrawTimes times;
    renderer->clear_view_cache();
    const Result<Image> drawn = renderer->draw(frame, &times);
    EXPECT_TRUE(drawn.ok()) << drawn.status().message;
    return times.counters;
  }
  /// Counters of a frame after everything that is made only once has been made.
  FrameCounters settled(const std::string& members) {
    drawn(request(members));
    drawn(request(members));
    return drawn(request(members));
  }

  /// Runs the commands. Returns true if they changed anything that can be undone.
  bool execute(const std::string& commands) {
    if (commands.empty()) return false;
    const Revision before = scene_->revision();
    const Status status = carry_out(commands, *scene_, *store_);
    EXPECT_TRUE(status.ok()) << status.message << " " << status.pointer;
    return scene_->revision() != before;
  }
  void undo() { EXPECT_TRUE(scene_->move(Undo{1}).ok()); }

  FreshStore store_{"pelage_needs" + std::to_string(static_cast<int>(GetParam()))};
  std::shared_ptr<Scene> scene_;
  std::optional<std::uint64_t> drawn_;  // number of the last change that the renderer has
};

TEST_P(Needs, NothingWhereAFeatureIsNamedAndNotUsed) {
  const FrameCounters plain = settled("");
  for (const Feature& feature : features()) {
    SCOPED_TRACE(feature.name);
    const bool changed = execute(feature.rest_commands);
    EXPECT_EQ(settled(feature.rest_frame), plain);
    if (changed) undo();
  }
}

TEST_P(Needs, NothingAfterAFeatureIsTakenAway) {
  const FrameCounters plain = settled("");
  for (const Feature& feature : features()) {
    if (feature.commands.empty() && feature.frame.empty()) continue;
    SCOPED_TRACE(feature.name);
    const bool changed = execute(feature.commands);
    const FrameCounters first = drawn(request(feature.frame)), used = settled(feature.frame);
    const bool only_values = feature.name == "edit layers";  // longer fur is no extra work
    EXPECT_TRUE(only_values || used != plain || first != plain) << "not seen by the counters";
    if (changed) undo();
    EXPECT_EQ(settled(""), plain);
  }
}

// A frame that is drawn again creates no GL objects.
TEST_P(Needs, NoNewObjectsFromFrameToFrame) {
  EXPECT_EQ(settled("").objects, 0u);
  for (const Feature& feature : features()) {
    SCOPED_TRACE(feature.name);
    if (feature.name == "sorted order") continue;  // its lists are large, and freed after each frame
    const bool changed = execute(feature.commands);
    EXPECT_EQ(settled(feature.frame).objects, 0u);
    if (changed) undo();
  }
}

INSTANTIATE_TEST_SUITE_P(Both, Needs, both_backends(), name_of);

}  // namespace
}  // namespace testing
}  // namespace pelage
