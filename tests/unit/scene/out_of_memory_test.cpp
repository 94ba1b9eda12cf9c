// If memory runs out in the middle of a change, the scene and its store stay as they were.
#include <functional>
#include <ostream>

#include "tests/unit/scene/failing_allocation.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::out_of_memory_test {
namespace {

class OutOfMemory : public StoreTest {
 protected:
  static constexpr std::size_t rounds_between_openings = 500;

  /// The state of a scene that a client sees.
  struct Seen {
    Revision revision;
    FieldsHash hash;
    std::size_t undo_steps, redo_steps, entries;
    double root_share;
    bool operator==(const Seen&) const = default;
    friend void PrintTo(const Seen& seen, std::ostream* out) {
      *out << "revision " << seen.revision << ", hash " << std::hex << seen.hash.high << std::dec << ", "
           << seen.undo_steps << " to undo, " << seen.redo_steps << " to redo, " << seen.entries
           << " entries, root share " << seen.root_share;
    }
  };
  static Seen seen(const Scene& scene) {
    const SceneSummary summary = scene.summary();
    double root_share = 0;
    root_share = scene.snapshot()->settings->coats[0].coat.root_share;
    return {summary.revision,   summary.fields_hash, summary.undo_steps,
            summary.redo_steps, scene.log().size(),  root_share};
  }

  std::shared_ptr<Scene> reopened() {
    const std::string id = scene_->id();
    scene_.reset();
    open();
    return store_ ? *store_->find(id) : nullptr;
  }

  /// Fails each allocation of a change in turn, until the change succeeds.
  void fail_each_allocation(const std::function<Result<CommandAnswer>(Scene&)>& change) {
    const Seen before = seen(*scene_);
    for (std::size_t number = 0;; ++number) {
      FailingAllocation failing(number);
      try {
        const Result<CommandAnswer> answer = change(*scene_);
        if (!failing.failed()) {
          ASSERT_TRUE(answer.ok()) << answer.status().message << " after " << number << " allocations";
          break;
        }
        ASSERT_FALSE(answer.ok()) << "allocation " << number;
      } catch (const std::bad_alloc&) {
      }
      ASSERT_EQ(seen(*scene_), before) << "allocation " << number;
      if (number % rounds_between_openings != 0) continue;
      scene_ = reopened();
      ASSERT_TRUE(scene_) << "reopened after allocation " << number;
      ASSERT_EQ(seen(*scene_), before) << "reopened after allocation " << number;
    }
    const Seen after = seen(*scene_);
    EXPECT_NE(after, before);
    scene_ = reopened();
    ASSERT_TRUE(scene_);
    EXPECT_EQ(seen(*scene_), after);
  }

  /// Commands of many kinds: tools, an edit layer, settings and an environment picture.
  std::vector<Command> batch() const {
    Length shorter;
    shorter.stroke = stroke_at(*scene_, 9);
    shorter.brush.radius = 0.1;
    Comb comb = comb_at(*scene_, 5);
    comb.edit_layer = "summer";
    SetCoat coat;
    coat.coat.root_share = 0.25;
    return {ChangeEditLayer{.name = "summer"}, comb, shorter, coat, Checkpoint{"cut", {}}};
  }

  std::shared_ptr<Scene> scene_;
};

TEST_F(OutOfMemory, AnUndoHappensWholeOrNotAtAll) {
  scene_ = make(Builtin::torus, 200);
  execute(*scene_, batch());
  fail_each_allocation([](Scene& scene) { return scene.move(Undo{1}); });
  fail_each_allocation([](Scene& scene) { return scene.move(Redo{1}); });
}

}  // namespace
}  // namespace pelage::out_of_memory_test
