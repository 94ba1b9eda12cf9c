// The server accepts the looks that come with the client.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "clients/cli/recipe/split_steps.h"
#include "protocol/json/decode.h"

namespace pelage {
namespace {

const std::filesystem::path looks_folder = std::filesystem::path(PELAGE_SOURCE_DIR) / "clients/looks";

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Looks, EveryOneIsThere) {
  for (const char* name :
       {"shorthair_cat", "rabbit", "fox", "sheep", "wet_dog", "bear", "zebra", "leopard", "toy_plush"}) {
    EXPECT_TRUE(std::filesystem::exists(looks_folder / (std::string(name) + ".json"))) << name;
  }
}

TEST(Looks, AreOneStepThatSetsCoatAndLook) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(looks_folder)) {
    ++count;
    const auto steps = split_steps(text_of(entry.path()));
    ASSERT_TRUE(steps.ok()) << entry.path() << steps.status().message;
    ASSERT_EQ(steps->size(), 1u) << entry.path();
    const auto commands = decode_commands(steps->front());
    ASSERT_TRUE(commands.ok()) << entry.path() << " " << commands.status().pointer << " " << commands.status().message;
    ASSERT_EQ(commands->size(), 2u) << entry.path();
    EXPECT_TRUE(std::holds_alternative<SetCoat>(commands->at(0))) << entry.path();
    EXPECT_TRUE(std::holds_alternative<SetLook>(commands->at(1))) << entry.path();
  }
  EXPECT_GE(count, 9);
}

}  // namespace
}  // namespace pelage
