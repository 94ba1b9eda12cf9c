// The matrix of science.md 7. Each row is rasterized, drawn as shells in both orders and traced in both transports, and
// is finite; or it is refused with a pointer and a limit. The page rows.md lists the same rows.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <tuple>

#include "tests/extremes/aov_checker.h"
#include "tests/extremes/row.h"
#include "tests/extremes/row_scene.h"
#include "tests/extremes/with_store.h"

namespace pelage::testing::matrix_test {
namespace {

class Matrix : public ::testing::TestWithParam<std::tuple<Backend, std::string>> {
 protected:
  void SetUp() override {
    const Result<Renderer*> made = stage.renderer(std::get<0>(GetParam()));
    if (!made && !in_ci()) GTEST_SKIP() << made.status().message;
    ASSERT_TRUE(made.ok()) << made.status().message;
    renderer_ = *made;
  }
  void TearDown() override {
    if (!renderer_) return;
    EXPECT_EQ((*stage.context(std::get<0>(GetParam())))->gl().GetError(), GLenum{GL_NO_ERROR});
  }

  Renderer* renderer_ = nullptr;
};

Status outcome_of(const Row& row, SceneStore& store, AovChecker& checker, std::string& complaint) {
  const Result<std::shared_ptr<Scene>> scene = scene_of(row, store);
  if (!scene) return scene.status();
  const Result<FrameRequest> request = request_of(row);
  if (!request) return request.status();
  return checker.look_at(**scene, *request, complaint);
}

void expect_refused(const Row& row, const Status& status) {
  ASSERT_FALSE(status.ok()) << "drawn";
  EXPECT_FALSE(status.message.empty());
  if (row.refused == "model") return;  // a refused file has no pointer
  EXPECT_EQ(status.pointer, row.refused) << status.message;
  EXPECT_FALSE(status.limit.empty()) << status.message;
}

TEST_P(Matrix, IsDrawnFiniteOrRefused) {
  const auto& [backend, area] = GetParam();
  FreshStore store("pelage_matrix_" + area + std::to_string(static_cast<int>(backend)));
  AovChecker checker(*renderer_);
  const Rows rows = rows_of(area);
  ASSERT_FALSE(rows.empty());
  std::size_t refused = 0;
  for (const Row& row : rows) {
    SCOPED_TRACE(row.area + ": " + row.value);
    std::string complaint;
    const Status status = outcome_of(row, *store, checker, complaint);
    EXPECT_EQ(complaint, "");
    if (row.refused.empty()) {
      EXPECT_TRUE(status.ok()) << status.message << " " << status.pointer << " " << status.limit;
    } else {
      expect_refused(row, status);
      ++refused;
    }
    for (const SceneSummary& scene : store->list()) {
      const auto made = store->find(scene.id);
      renderer_->forget((*made)->model()->id);
      EXPECT_TRUE(store->remove(scene.id).ok());
    }
  }
  std::printf("%s: %zu rows, %zu refused, %zu pictures\n", area.c_str(), rows.size(), refused, checker.pictures());
}

std::string name_of_area(const ::testing::TestParamInfo<std::tuple<Backend, std::string>>& info) {
  return name_of_backend(std::get<0>(info.param)) + "_" + std::get<1>(info.param);
}

INSTANTIATE_TEST_SUITE_P(Both, Matrix, ::testing::Combine(both_backends(), ::testing::ValuesIn(areas())), name_of_area);

std::string table() {
  std::ostringstream text;
  std::size_t rows = 0, refused = 0;
  text << "| area | value | what comes |\n|---|---|---|\n";
  for (const std::string& area : areas()) {
    for (const Row& row : rows_of(area)) {
      ++rows, refused += !row.refused.empty();
      text << "| " << row.area << " | " << row.value << " | "
           << (row.refused.empty()      ? "drawn"
               : row.refused == "model" ? "refused"
                                        : "refused: `" + row.refused + "`")
           << " |\n";
    }
  }
  text << "\n"
       << rows << " rows: " << rows - refused
       << " drawn, each rasterized, as shells in both orders, as traced strands and as "
       << "paths, on both backends (" << 10 * (rows - refused) << " pictures), and " << refused << " refused.\n";
  return text.str();
}

// PELAGE_WRITE_PAGE=1 writes the rows into the page instead of comparing.
TEST(MatrixPage, ListsTheRows) {
  const std::string begin = "<!-- rows -->\n", end = "<!-- end of rows -->\n";
  std::ifstream file(PELAGE_EXTREMES_PAGE);
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::size_t first = page.find(begin), last = page.find(end);
  ASSERT_NE(first, std::string::npos);
  ASSERT_NE(last, std::string::npos);
  const std::string expected = page.substr(0, first + begin.size()) + table() + page.substr(last);
  if (std::getenv("PELAGE_WRITE_PAGE")) {
    std::ofstream(PELAGE_EXTREMES_PAGE) << expected;
  } else {
    EXPECT_TRUE(page == expected) << "run extremes_tests with PELAGE_WRITE_PAGE=1 after changing rows";
  }
}

}  // namespace
}  // namespace pelage::testing::matrix_test
