#include <limits>

#include "protocol/json/encode.h"
#include "tests/unit/scene/store_fixture.h"

namespace pelage::cancel_test {
namespace {

class CancelTest : public StoreTest {
 protected:
  /// A client that keeps waiting for `left` polls of the cancel, and counts the polls.
  struct Waiting {
    int left = std::numeric_limits<int>::max();
    int asked = 0;
    ExecuteOptions options() {
      return {.cancel = Cancel([this] {
                ++asked;
                return left-- <= 0;
              })};
    }
  };
  static std::vector<Command> commands(const Scene& scene) {
    Smooth smooth{.flood = true, .passes = 6};
    Interpolate keys;
    keys.keys = {{.position = vertex_position(scene, 3), .length = 0.1}};
    return {comb_at(scene, 0), smooth, keys, ChangeMask{.action = MaskAction::smooth, .passes = 5}};
  }
};

TEST_F(CancelTest, WhereverItEndsNothingChanges) {
  const auto scene = make();
  execute(*scene, {comb_at(*scene, 5)});
  const FieldsHash before = hash(*scene);
  const std::string log = encode(Log{scene->log()});
  Waiting counted;
  ExecuteOptions dry = counted.options();
  dry.dry_run = true;
  ASSERT_TRUE(scene->execute(commands(*scene), dry).ok());
  ASSERT_GT(counted.asked, 15);  // polled by dabs, passes and images, not only by commands
  for (int left = 0; left < counted.asked; ++left) {
    Waiting waiting{left};
    const Result<CommandAnswer> answer = scene->execute(commands(*scene), waiting.options());
    ASSERT_FALSE(answer.ok()) << left;
    EXPECT_EQ(answer.status().code, Code::unavailable);
    EXPECT_EQ(waiting.asked, left + 1) << "went on after nobody waited";
    EXPECT_EQ(hash(*scene), before);
    EXPECT_EQ(encode(Log{scene->log()}), log);
  }
  Waiting enough{counted.asked};
  EXPECT_TRUE(scene->execute(commands(*scene), enough.options()).ok());
}

TEST_F(CancelTest, AnAmendmentEndsToo) {
  const auto scene = make();
  execute(*scene, {comb_at(*scene, 5)});
  execute(*scene, commands(*scene));
  const FieldsHash before = hash(*scene);
  Waiting waiting{10};
  const Result<CommandAnswer> answer = scene->amend({1, {comb_at(*scene, 9)}}, waiting.options());
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.status().code, Code::unavailable);
  EXPECT_EQ(hash(*scene), before);
  EXPECT_EQ(scene->revision(), 2u);
}

}  // namespace
}  // namespace pelage::cancel_test
