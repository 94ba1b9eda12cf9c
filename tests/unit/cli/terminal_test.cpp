// What the client writes on a terminal.
#include <gtest/gtest.h>

#include "clients/cli/terminal/progress.h"
#include "clients/cli/terminal/table.h"

namespace pelage {
namespace {

TEST(Progress, ShowsABarWhereTheShareIsKnown) {
  EXPECT_EQ(progress_text("running", {0.5, "step 3 of 6"}, 4.2),
            "running [##########..........]  50 %, step 3 of 6, 4 s");
  EXPECT_EQ(progress_text("running", {1.5, ""}, 4), "running [####################] 100 %, 4 s");
  EXPECT_EQ(progress_text("exporting", {-1, "3.1 MB"}, 12), "exporting, 3.1 MB, 12 s");
}

TEST(Table, LinesUpItsColumns) {
  EXPECT_EQ(table_of({{"id", "name", "triangles"}, {"a1", "f\xc3\xbcr", "12"}, {"b", "koala", "20000"}}),
            "id  name   triangles\n"
            "a1  f\xc3\xbcr           12\n"
            "b   koala      20000\n");
}

}  // namespace
}  // namespace pelage
