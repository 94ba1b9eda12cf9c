// Files that would be too large to read are refused when they are written.
#include <gtest/gtest.h>

#include <filesystem>

#include "server/export/export_file.h"
#include "server/export/glb_writer.h"

namespace pelage::file_size_test {
namespace {

TEST(FileSize, AGlbBeyondItsLimitIsRefused) {
  const std::vector<glm::vec3> hundred(100, glm::vec3(1));  // 1200 bytes
  GlbWriter fits(2000), large(2000), text(1300);
  fits.add(hundred);
  const Result<std::string> whole = fits.finish();
  ASSERT_TRUE(whole.ok()) << whole.status().message;
  EXPECT_LE(whole->size(), 2000u);
  large.add(hundred), large.add(hundred);
  EXPECT_EQ(large.finish().status().code, Code::too_large);
  EXPECT_EQ(large.finish().status().limit, "at most 2000 bytes");
  text.add(hundred);  // the numbers fit, but not together with their description
  EXPECT_EQ(text.finish().status().code, Code::too_large);
}

TEST(FileSize, ItIsThatOfAllPartsInTheirOrder) {
  const auto text = [](std::string of) { return [of](const Sink& sink) { return sink(of); }; };
  ExportFile file;
  for (int i = 0; i < 1000; ++i) file.parts.push_back(text(std::to_string(i) + " "));
  std::string whole;
  EXPECT_TRUE(file.write([&](std::string_view chunk) { return whole += chunk, true; }));
  EXPECT_EQ(whole.substr(0, 8), "0 1 2 3 ");
  EXPECT_EQ(size_of(file.parts, {}), whole.size());
  int asked = 0;
  EXPECT_FALSE(file.write([&](std::string_view) { return ++asked < 3; }));
  EXPECT_EQ(asked, 3);  // nothing more is written after the sink has refused
}

TEST(FileSize, ASavedSceneThatWouldNotOpenIsRefused) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "pelage_file_size";
  std::filesystem::remove_all(folder);
  const auto store = SceneStore::open(folder.string(), "pelage-import");
  ASSERT_TRUE(store.ok());
  const auto scene = (*store)->create({"test", {Builtin::torus, 500}, {}});
  ASSERT_TRUE(scene.ok());
  const Result<ExportFile> file = export_saved(**store, **scene);
  ASSERT_TRUE(file.ok()) << file.status().message;
  EXPECT_TRUE(export_saved(**store, **scene, {}, {.bytes = file->about.bytes}).ok());
  EXPECT_EQ(export_saved(**store, **scene, {}, {.bytes = file->about.bytes - 1}).status().code, Code::too_large);
  EXPECT_EQ(export_saved(**store, **scene, {}, {.unpacked = 4096}).status().code, Code::too_large);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace pelage::file_size_test
