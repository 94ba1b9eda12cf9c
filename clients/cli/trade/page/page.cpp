#include "clients/cli/trade/page/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "clients/cli/trade/page/advice.h"
#include "clients/cli/trade/page/front.h"
#include "clients/cli/trade/page/html.h"
#include "clients/cli/trade/page/plots.h"
#include "clients/cli/trade/page/svg.h"

namespace pelage::trade {

namespace {

std::string introduction(const Report& report) {
  const bool cpu = std::any_of(report.rows.begin(), report.rows.end(), [](const Row& row) { return row.cpu_ms > 0; });
  return fmt::format(
      "<p>How much time each quality takes, and how far its picture is from the truth. Drawn by <b>{}</b> at {} x {} "
      "pixels. Another machine, above all another GPU, has other times: run <code>pelage trade</code> there.</p>"
      "<p><b>Error</b> is FLIP, the difference that an eye sees when two pictures are swapped in place, from 0 to 1, "
      "over "
      "the fur only. <b>Outline</b> is the same in a band of 8 pixels to each side of its edge. <b>Time</b> is {} of "
      "drawing, shadows included, without sending and encoding: the least of {}.</p>"
      "<p>The truth is <b>R1</b>, the same fur with the same shadows in {} layers with every fragment sorted. "
      "<b>R2</b> traces every "
      "strand; it shows what layers and light leave out.</p>",
      escaped(report.renderer), report.size, report.size,
      cpu ? "milliseconds of CPU on all threads" : "wall milliseconds", report.repeats, report.truth);
}

std::string tier_table(const std::vector<Row>& rows) {
  Table table{{"tier", "scene", "truth", "error", "95 of 100 pixels under", "outline", "light over truth",
               "coverage over truth", "ms"},
              {}};
  for (const char* tier : {"draft", "interactive", "detailed"}) {
    for (const Row& row : rows) {
      if (row.series != "tier" || row.value != tier) continue;
      table.rows.push_back({tier, row.scene, row.reference, fmt::format("{:.4f}", row.flip),
                            fmt::format("{:.3f}", row.flip_95), fmt::format("{:.4f}", row.outline),
                            fmt::format("{:.3f}", row.luminance), fmt::format("{:.3f}", row.coverage),
                            milliseconds(cost_of(row))});
    }
  }
  return "<details><summary>The figures of the tiers, R2 included</summary>" + table_html(table) + "</details>";
}

/// How sure the reference is, and whether a pixel was broken.
std::string checks(const std::vector<Row>& rows) {
  std::size_t broken = 0;
  double floor = 0, least = 1;
  for (const Row& row : rows) {
    broken += row.non_finite;
    if (!against_shells(row)) continue;
    floor = std::max(floor, row.floor);
    least = std::min(least, row.flip);
  }
  const char* verdict = floor <= least / 10
                            ? "The truth is proved: that is less than a tenth of the smallest error here."
                            : "Errors under ten times that are not proved: the truth itself may be off by so much.";
  return fmt::format(
      "<ul><li>Pixels that are not finite: <b>{}</b>, in {} frames.</li><li>R1 with half its layers differs "
      "from R1 by at most {:.4f}. The smallest error is {:.4f}. {}</li></ul>",
      broken, rows.size(), floor, least, verdict);
}

std::string for_each_scene(const std::vector<Row>& rows,
                           std::string (*plot)(const std::vector<Row>&, const std::string&)) {
  std::string text;
  for (const std::string& scene : swept_scenes(rows))
    text += "<div><h3>" + escaped(scene) + "</h3>" + plot(rows, scene) + "</div>";
  return text;
}

std::string image(const std::string& jpeg, const std::string& text) {
  return "<img alt=\"" + escaped(text) + "\" src=\"data:image/jpeg;base64," + base64(jpeg) + "\" />";
}

std::string figure(const Picture& picture) {
  std::string text = "<figure>" + image(picture.jpeg, picture.name + ", " + picture.scene);
  if (!picture.map.empty()) text += image(picture.map, "error of " + picture.name);
  return text + "<figcaption><b>" + escaped(picture.name) + "</b> " + escaped(picture.caption) +
         "</figcaption></figure>";
}

std::string gallery(const std::vector<Picture>& pictures) {
  std::string text, scene;
  for (const Picture& picture : pictures) {
    if (picture.scene != scene)
      text += (scene.empty() ? "" : "</div>") + ("<h3>" + escaped(picture.scene)) + "</h3><div class=\"pictures\">";
    scene = picture.scene;
    text += figure(picture);
  }
  return text + (pictures.empty() ? "" : "</div>");
}

std::string all_rows(const std::vector<Row>& rows) {
  Table table{{"scene", "setting", "truth", "error", "95%", "outline", "ms", "CPU ms"}, {}};
  for (const Row& row : rows) {
    table.rows.push_back({row.scene, name_of(row), row.reference, fmt::format("{:.4f}", row.flip),
                          fmt::format("{:.3f}", row.flip_95), fmt::format("{:.4f}", row.outline),
                          milliseconds(row.draw_ms), row.cpu_ms > 0 ? milliseconds(row.cpu_ms) : ""});
  }
  return "<details><summary>Everything that was measured; results.csv has it with all knobs</summary><div "
         "class=\"all\">" +
         table_html(table) + "</div></details>";
}

}  // namespace

std::string page(const Report& report) {
  const std::vector<Row>& rows = report.rows;
  std::string text = introduction(report);
  text += section("What to choose when", advice_html(rows));
  text +=
      section("Side by side", "<p>Below each picture its error map: black is none, yellow is as wrong as can be.</p>" +
                                  gallery(report.pictures));
  text += section("Where the tiers lie", tier_plot(rows) + tier_table(rows));
  text += section("Error against time",
                  "<p>Each dot is a setting; rest the pointer on it for its name. Nothing lies below the "
                  "line: it is the best that each time buys.</p><div class=\"panels\">" +
                      for_each_scene(rows, scatter_plot) + "</div>");
  text += section("What each knob buys",
                  "<p>One knob is turned, the others stay as in the tier of that colour. Left is faster, "
                  "down is better: a good knob goes down and hardly to the right.</p>" +
                      for_each_scene(rows, knob_plots));
  text += section(
      "More shells, less error",
      "<p>The order says how fast: with order 1 twice the shells halve the error.</p>" + convergence_plot(rows));
  text += section("Is it sound?", checks(rows) + all_rows(rows));
  return document("Speed for accuracy", text);
}

}  // namespace pelage::trade
