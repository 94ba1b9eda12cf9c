#include <atomic>
#include <cmath>
#include <memory>

#include "server/groom/evaluation_cost.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::check_cost_test {
namespace {

class CheckCostTest : public StoreTest {
 protected:
  static SetSymmetry all_images() {
    SetSymmetry set;
    set.symmetry.planes = {{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 0, 1}}};
    set.symmetry.count = 16;
    return set;
  }
  /// Starts commands. If they are not refused, they are cancelled at a poll, so that a missing check does not take
  /// minutes.
  static Result<CommandAnswer> begin(Scene& scene, const std::vector<Command>& commands) {
    const auto admitted = std::make_shared<std::atomic<bool>>(false);
    return scene.execute(commands, {.cancel = Cancel([admitted] { return admitted->exchange(true); })});
  }
  /// A stroke of 5,000 samples back and forth, with falloff along the surface.
  static Comb heavy(const Scene& scene) {
    Comb comb = comb_at(scene, 0);
    comb.brush.falloff_shape = FalloffShape::surface;
    comb.stroke->samples.clear();
    for (std::size_t i = 0; i < 5000; ++i) {
      StrokeSample sample;
      sample.position = PositionSample{vertex_position(scene, 7 * i)};
      comb.stroke->samples.push_back(sample);
    }
    return comb;
  }
};

TEST_F(CheckCostTest, AStrokeOf128ImagesIsRefusedAndNothingChanges) {
  const auto scene = make(Builtin::torus, 20000);
  execute(*scene, {all_images()});
  const FieldsHash before = hash(*scene);
  const Result<CommandAnswer> answer = begin(*scene, {heavy(*scene)});
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.status().code, Code::invalid);
  EXPECT_EQ(answer.status().pointer, "/stroke/samples");
  EXPECT_FALSE(answer.status().limit.empty());
  EXPECT_EQ(scene->revision(), 1u);
  EXPECT_EQ(hash(*scene), before);
  EXPECT_EQ(scene->log().size(), 1u);
}

TEST_F(CheckCostTest, TheSymmetryOfTheBatchCounts) {
  const auto scene = make(Builtin::torus, 20000);
  const Result<CommandAnswer> answer = begin(*scene, {all_images(), heavy(*scene)});
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.status().code, Code::invalid);
  EXPECT_EQ(answer.status().pointer, "/commands/1/stroke/samples");
  EXPECT_EQ(scene->revision(), 0u);
}

}  // namespace
}  // namespace pelage::check_cost_test
