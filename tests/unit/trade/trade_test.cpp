#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stack>

#include "clients/cli/trade/page/page.h"
#include "clients/cli/trade/page/plots.h"

namespace pelage::trade {
namespace {

using Indices = std::vector<std::size_t>;

TEST(ParetoFront, KeepsWhatNothingBeatsInBoth) {
  EXPECT_EQ(pareto_front({4, 1, 2, 3, 2}, {0.1, 0.9, 0.5, 0.6, 0.4}), (Indices{1, 4, 0}));
}

TEST(ParetoFront, OfEqualPointsTheFirstStays) { EXPECT_EQ(pareto_front({1, 1, 1}, {2, 2, 3}), (Indices{0})); }

TEST(ParetoFront, OfNothingIsNothingAndSkipsWhatIsNoNumber) {
  EXPECT_TRUE(pareto_front({}, {}).empty());
  EXPECT_EQ(pareto_front({1, 2}, {std::numeric_limits<double>::quiet_NaN(), 1}), (Indices{1}));
}

TEST(FittedOrder, FindsThePowerOfAPowerLaw) {
  std::vector<double> x, y;
  for (const double n : {2.0, 5.0, 9.0, 40.0}) x.push_back(n), y.push_back(0.7 * std::pow(n, -1.5));
  EXPECT_NEAR(fitted_order(x, y).value_or(0), 1.5, 1e-9);
  EXPECT_FALSE(fitted_order({4, 4}, {1, 2}).has_value());
}

Row row_of(const std::string& scene, const std::string& series, const std::string& value, double ms, double flip) {
  Row row{.scene = scene,
          .size = 64,
          .series = series,
          .base = series == "tier" ? "" : "interactive",
          .value = value,
          .reference = "R1",
          .knobs = "{\"of\":\"" + series + value + "\"}"};
  row.shells = 8, row.steps = 3, row.flip = flip, row.flip_95 = 2 * flip, row.silhouette = 1.5 * flip, row.draw_ms = ms;
  return row;
}

/// Two scenes with tiers, a knob and a grid; names that HTML has to escape.
std::vector<Row> some_rows() {
  std::vector<Row> rows;
  for (const char* scene : {"a <b> & \"c\"", "second, far"}) {
    rows.push_back(row_of(scene, "tier", "draft", 10, 0.08));
    rows.push_back(row_of(scene, "tier", "interactive", 40, 0.03));
    rows.push_back(row_of(scene, "tier", "detailed", 300, 0.012));
    rows.push_back(row_of(scene, "shells", "4", 20, 0.06));
    rows.push_back(row_of(scene, "shells", "8", 39, 0.02));
    rows.back().shells = 16;
    rows.push_back(row_of(scene, "grid", "2 x 1 x 0.5", 5, 0.12));
  }
  rows.push_back(row_of("only tiers", "tier", "draft", 10, 0.08));
  Row strands = row_of("second, far", "tier", "draft", 10, 0.3);
  strands.reference = "R2";
  rows.insert(rows.begin() + 1, strands);  // before those that it must not be taken for
  return rows;
}

TEST(Table, ReadsBackToTheSameRows) {
  std::vector<Row> rows = some_rows();
  rows[0].flip = 1.0 / 3, rows[0].cpu_ms = 1e-17, rows[0].non_finite = 7, rows[0].knobs = "a\"b,\nc";
  const auto read = from_csv(to_csv(rows));
  ASSERT_TRUE(read.ok()) << read.status().message;
  EXPECT_EQ(*read, rows);
}

TEST(Table, RefusesOtherColumnsAndBrokenLines) {
  EXPECT_FALSE(from_csv("a,b\r\n").ok());
  EXPECT_FALSE(from_csv("").ok());
  const std::string good = to_csv(some_rows());
  EXPECT_FALSE(from_csv(good + "one,two\r\n").ok());
  std::string bad = good;
  bad.replace(bad.find(",64,"), 4, ",6x,");
  const auto read = from_csv(bad);
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.status().message.find("Row 1"), std::string::npos);
}

TEST(Means, AreOfSettingsThatAllScenesHave) {
  const std::vector<Row> rows = some_rows();
  const auto means = means_over(rows, swept_scenes(rows));
  ASSERT_EQ(means.size(), 6u);
  EXPECT_EQ(means[0].name, "draft");
  EXPECT_NEAR(means[0].flip, 0.08, 1e-12);  // R2 is not mixed in
  EXPECT_NEAR(means[0].cost, 10, 1e-9);
  EXPECT_EQ(means_over(rows, all_scenes(rows)).size(), 1u);
}

TEST(Advice, ChoosesTheBestWithinATimeAndTheCheapestAtAnError) {
  const std::vector<Row> rows = some_rows();
  const auto means = means_over(rows, swept_scenes(rows));
  EXPECT_EQ(best_within(means, 39.5).value_or(Mean{}).name, "interactive with shells 8");
  EXPECT_EQ(cheapest_at(means, 0.08).value_or(Mean{}).name, "draft");
  EXPECT_FALSE(best_within(means, 1).has_value());
  EXPECT_FALSE(cheapest_at(means, 0.001).has_value());
  EXPECT_NE(advice_html(rows).find("For the same time, interactive with shells 8 has"), std::string::npos);
}

TEST(Advice, SaysSoWhenThereIsTooLittle) { EXPECT_NE(advice_html({}).find("Not enough"), std::string::npos); }

TEST(Axes, AreLogarithmicAndHoldTheirArea) {
  const Axes axes{.left = 10, .top = 0, .width = 100, .height = 100, .x = {1, 100}, .y = {1, 100}};
  EXPECT_DOUBLE_EQ(axes.to_x(10), 60);
  EXPECT_DOUBLE_EQ(axes.to_y(10), 50);
  EXPECT_DOUBLE_EQ(axes.to_x(1e9), 110);
  EXPECT_DOUBLE_EQ(axes.to_y(0), 100);
}

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
}

/// "" when every tag is closed in order, else the first that is not.
std::string open_tag_in(const std::string& text) {
  std::stack<std::string> open;
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return "an end is missing";
    const std::string tag = text.substr(at + 1, end - at - 1), name = tag.substr(0, tag.find_first_of(" /", 1));
    if (tag.starts_with("!") || tag.ends_with("/")) continue;
    if (!tag.starts_with("/")) {
      open.push(name);
    } else {
      if (open.empty() || "/" + open.top() != tag) return tag;
      open.pop();
    }
  }
  return open.empty() ? "" : open.top();
}

TEST(Page, IsWellFormedAndNeedsNothingElse) {
  Report report{.renderer = "a <GL> & more", .size = 64, .rows = some_rows()};
  report.pictures = {{"second, far", "R1", "truth", "bytes", ""}, {"second, far", "draft", "error", "bytes", "map"}};
  const std::string text = page(report);
  EXPECT_EQ(open_tag_in(text), "");
  EXPECT_EQ(text.find("http"), std::string::npos);
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_EQ(text.find("<b> &"), std::string::npos);
  EXPECT_NE(text.find("a &lt;GL&gt; &amp; more"), std::string::npos);
  EXPECT_NE(text.find("data:image/jpeg;base64,Ynl0ZXM="), std::string::npos);
}

TEST(Page, OfNothingIsAPageAsWell) { EXPECT_EQ(open_tag_in(page({})), ""); }

TEST(Page, SaysWhenTheTruthIsNotProved) {
  Report report;
  report.rows = some_rows();
  EXPECT_NE(page(report).find("The truth is proved"), std::string::npos);
  report.rows[0].floor = 0.002;
  EXPECT_NE(page(report).find("are not proved"), std::string::npos);
}

TEST(Plots, ShowTheTiersAndTheKnobs) {
  const std::vector<Row> rows = some_rows();
  const std::string scatter = scatter_plot(rows, "second, far");
  EXPECT_NE(scatter.find("draft: 10 ms, FLIP 0.0800"), std::string::npos);
  EXPECT_EQ(scatter.find("FLIP 0.3000"), std::string::npos);  // R2 is another error
  EXPECT_NE(knob_plots(rows, "second, far").find("What shells buys"), std::string::npos);
  EXPECT_NE(convergence_plot(rows).find("order 1.58"), std::string::npos);  // log2(.06 / .02)
  EXPECT_NE(tier_plot(rows).find("only tiers"), std::string::npos);
}

}  // namespace
}  // namespace pelage::trade
