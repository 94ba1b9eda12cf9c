#include "clients/cli/trade/page/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "clients/cli/trade/page/plots.h"
#include "clients/cli/trade/page/row.h"

namespace pelage::trade {

namespace {

std::vector<std::string> scenes_of(const std::vector<Row>& rows, bool only_swept) {
  std::vector<std::string> scenes;
  for (const Row& row : rows) {
    const bool wanted = !only_swept || row.series == "grid";
    if (wanted && std::find(scenes.begin(), scenes.end(), row.scene) == scenes.end()) scenes.push_back(row.scene);
  }
  return scenes;
}

}  // namespace

double cost_of(const Row& row) { return row.cpu_ms > 0 ? row.cpu_ms : row.draw_ms; }

std::string milliseconds(double value) {
  return value >= 100 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

bool against_shells(const Row& row) { return row.reference.starts_with("R1"); }

std::string name_of(const Row& row) {
  if (row.series == "tier") return row.value;
  if (row.series == "grid")
    return fmt::format("{} shells of {} steps at {:g} of the size", row.shells, row.steps, row.scale);
  return fmt::format("{} with {} {}", row.base, row.series, row.value);
}

std::vector<std::size_t> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors) {
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return costs[a] != costs[b] ? costs[a] < costs[b] : errors[a] < errors[b];
  });
  std::vector<std::size_t> front;
  double min = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(errors[i] < min)) continue;
    front.push_back(i);
    min = errors[i];
  }
  return front;
}

std::vector<Mean> means_over(const std::vector<Row>& rows, const std::vector<std::string>& scenes) {
  const std::set<std::string> wanted(scenes.begin(), scenes.end());
  std::vector<Mean> means;
  std::map<std::string, std::size_t> place;
  std::set<std::pair<std::string, std::string>> seen;
  for (const Row& row : rows) {
    if (!against_shells(row) || !wanted.contains(row.scene) || !seen.emplace(row.scene, row.knobs).second) continue;
    const auto [found, added] = place.emplace(row.knobs, means.size());
    if (added) means.push_back({.name = name_of(row), .knobs = row.knobs});
    Mean& mean = means[found->second];
    mean.cost += std::log(std::max(cost_of(row), 1e-3));
    mean.flip += row.flip, mean.silhouette += row.silhouette, ++mean.scenes;
  }
  for (Mean& mean : means) {
    mean.cost = std::exp(mean.cost / mean.scenes);
    mean.flip /= mean.scenes, mean.silhouette /= mean.scenes;
  }
  std::erase_if(means, [&](const Mean& mean) { return mean.scenes != static_cast<int>(wanted.size()); });
  return means;
}

std::vector<std::string> swept_scenes(const std::vector<Row>& rows) { return scenes_of(rows, true); }
std::vector<std::string> all_scenes(const std::vector<Row>& rows) { return scenes_of(rows, false); }

std::optional<double> fitted_order(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double u = std::log(x[i]), v = std::log(y[i]);
    sx += u, sy += v, sxx += u * u, sxy += u * v;
  }
  const double spread = n * sxx - sx * sx;
  if (!(spread > 1e-12)) return std::nullopt;
  return -(n * sxy - sx * sy) / spread;
}

}  // namespace pelage::trade

namespace pelage::trade {

namespace {

constexpr double row_height = 26;

std::string key(double y) {
  std::string text;
  double x = 400;
  for (const char* tier : {"draft", "interactive", "detailed"}) {
    text += dot(x, y - 4, 6, tier_colour(tier), "") + label(x + 11, y, tier, "start", tier_colour(tier));
    x += 110;
  }
  return text + dot(x, y - 4, 5, "#555", "", true) + label(x + 11, y, "hollow: in the silhouette");
}

std::string marks_of(const Axes& axes, const Row& row, double y) {
  const std::string hint =
      fmt::format("{}, {}: FLIP {:.4f}, silhouette {:.4f}", row.scene, row.value, row.flip, row.silhouette);
  std::string text;
  if (row.silhouette > 0) text += dot(axes.to_x(row.silhouette), y, 5, tier_colour(row.value), hint, true);
  return text + dot(axes.to_x(row.flip), y, 6, tier_colour(row.value), hint);
}

}  // namespace

std::string tier_plot(const std::vector<Row>& rows) {
  const std::vector<std::string> scenes = all_scenes(rows);
  std::vector<double> errors;
  for (const Row& row : rows) {
    if (row.series == "tier" && against_shells(row)) errors.push_back(row.flip), errors.push_back(row.silhouette);
  }
  const Span no_ticks{2.1, 4.9};  // scenes have no scale
  const double height = row_height * static_cast<double>(scenes.size());
  const Axes axes{.left = 390, .top = 34, .width = 540, .height = height, .x = span_of(errors), .y = no_ticks};
  std::string content = key(16) + axes_svg(axes, "error (masked FLIP), less is better", "");
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const double y = axes.top + row_height * (static_cast<double>(i) + 0.5);
    content += label(axes.left - 12, y + 4, scenes[i], "end");
    for (const Row& row : rows) {
      if (row.scene == scenes[i] && row.series == "tier" && against_shells(row)) content += marks_of(axes, row, y);
    }
  }
  return svg(960, axes.top + axes.height + 50, "Where the tiers lie", content);
}

}  // namespace pelage::trade

namespace pelage::trade {

namespace {

constexpr double no_worse = 1.02;  // measured costs differ by so much from run to run

std::string ms(double value) { return milliseconds(value); }
std::string error(double value) { return fmt::format("{:.4f}", value); }

std::vector<std::string> cells_of(std::string wish, const std::optional<Mean>& choice) {
  if (!choice) return {std::move(wish), "nothing that was measured", "", "", ""};
  return {std::move(wish), choice->name, ms(choice->cost), error(choice->flip), error(choice->silhouette)};
}

std::string budget_table(const std::vector<Mean>& settings) {
  Table table{{"so many ms", "choose", "ms", "error", "silhouette"}, {}};
  const auto [min, max] = std::minmax_element(settings.begin(), settings.end(),
                                              [](const Mean& a, const Mean& b) { return a.cost < b.cost; });
  std::string last;
  for (const double budget : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000}) {
    const std::optional<Mean> choice = best_within(settings, budget);
    if (budget < min->cost || budget > 2 * max->cost || choice->name == last) continue;  // more time buys nothing
    table.rows.push_back(cells_of(ms(budget), choice));
    last = choice->name;
  }
  return table_html(table);
}

std::string error_table(const std::vector<Mean>& settings) {
  Table table{{"error of at most", "choose", "ms", "error", "silhouette"}, {}};
  for (const double wish : {0.08, 0.04, 0.03, 0.02, 0.015})
    table.rows.push_back(cells_of(fmt::format("{:.3f}", wish), cheapest_at(settings, wish)));
  return table_html(table);
}

/// Whether another setting is as cheap and better, in words.
std::string judgement(const std::vector<Mean>& settings, const Mean& tier) {
  const std::optional<Mean> better = best_within(settings, tier.cost * no_worse);
  const std::string start = fmt::format("<b>{}</b> takes {} ms with an error of {} (silhouette {}). ",
                                        escaped(tier.name), ms(tier.cost), error(tier.flip), error(tier.silhouette));
  if (!better || better->flip > 0.95 * tier.flip) return start + "Nothing measured is better for its time.";
  return start + fmt::format("For the same time, {} has {}.", escaped(better->name), error(better->flip));
}

}  // namespace

std::optional<Mean> best_within(const std::vector<Mean>& settings, double milliseconds) {
  std::optional<Mean> best;
  for (const Mean& mean : settings) {
    if (mean.cost <= milliseconds && (!best || mean.flip < best->flip)) best = mean;
  }
  return best;
}

std::optional<Mean> cheapest_at(const std::vector<Mean>& settings, double wanted) {
  std::optional<Mean> best;
  for (const Mean& mean : settings) {
    if (mean.flip <= wanted && (!best || mean.cost < best->cost)) best = mean;
  }
  return best;
}

std::string advice_html(const std::vector<Row>& rows) {
  const std::vector<std::string> scenes = swept_scenes(rows);
  const std::vector<Mean> settings = means_over(rows, scenes);
  if (settings.empty()) return "<p>Not enough was measured to say.</p>";
  std::string text = fmt::format(
      "<p>Means over {} on which every setting was tried. Choose by the time that you have, or by the error that you "
      "can live with: under .015 is hard to see even when pictures are swapped in place, .04 is seen when they are, "
      ".08 is seen side by side. The error is of shells, not of light: fur drawn without self-shadow is measured "
      "against such fur, though it looks brighter; look at the pictures too.</p>",
      scenes.size() == 1 ? "one scene" : fmt::format("{} scenes", scenes.size()));
  text +=
      "<div class=\"pair\"><div>" + budget_table(settings) + "</div><div>" + error_table(settings) + "</div></div><ul>";
  for (const char* tier : {"draft", "interactive", "detailed"}) {
    const auto found = std::find_if(settings.begin(), settings.end(), [&](const Mean& m) { return m.name == tier; });
    if (found != settings.end()) text += "<li>" + judgement(settings, *found) + "</li>";
  }
  return text + "</ul>";
}

}  // namespace pelage::trade

namespace pelage::trade {

namespace {

std::string introduction(const Report& report) {
  const bool cpu = std::any_of(report.rows.begin(), report.rows.end(), [](const Row& row) { return row.cpu_ms > 0; });
  return fmt::format(
      "<p>How much time each quality takes, and how far its picture is from the truth. Drawn by <b>{}</b> at {} x {} "
      "pixels. Another machine, above all another GPU, has other times: run <code>pelage trade</code> there.</p>"
      "<p><b>Error</b> is FLIP, the difference that an eye sees when two pictures are swapped in place, from 0 to 1, "
      "over "
      "the fur only. <b>Silhouette</b> is the same in a band of 8 pixels to each side of its edge. <b>Time</b> is {} "
      "of "
      "drawing, shadows included, without sending and encoding: the least of {}.</p>"
      "<p>The truth is <b>R1</b>, the same fur with the same shadows in {} shells with every fragment sorted. "
      "<b>R2</b> traces every "
      "strand; it shows what shells and light leave out.</p>",
      escaped(report.renderer), report.size, report.size,
      cpu ? "milliseconds of CPU on all threads" : "wall milliseconds", report.repeats, report.truth);
}

std::string tier_table(const std::vector<Row>& rows) {
  Table table{{"tier", "scene", "truth", "error", "95 of 100 pixels under", "silhouette", "light over truth",
               "coverage over truth", "ms"},
              {}};
  for (const char* tier : {"draft", "interactive", "detailed"}) {
    for (const Row& row : rows) {
      if (row.series != "tier" || row.value != tier) continue;
      table.rows.push_back({tier, row.scene, row.reference, fmt::format("{:.4f}", row.flip),
                            fmt::format("{:.3f}", row.flip_95), fmt::format("{:.4f}", row.silhouette),
                            fmt::format("{:.3f}", row.luminance), fmt::format("{:.3f}", row.coverage),
                            milliseconds(cost_of(row))});
    }
  }
  return "<details><summary>The figures of the tiers, R2 included</summary>" + table_html(table) + "</details>";
}

/// How sure the reference is, and whether a pixel was broken.
std::string checks(const std::vector<Row>& rows) {
  std::size_t broken = 0;
  double floor = 0, min = 1;
  for (const Row& row : rows) {
    broken += row.non_finite;
    if (!against_shells(row)) continue;
    floor = std::max(floor, row.floor);
    min = std::min(min, row.flip);
  }
  const char* verdict = floor <= min / 10
                            ? "The truth is proved: that is less than a tenth of the smallest error here."
                            : "Errors under ten times that are not proved: the truth itself may be off by so much.";
  return fmt::format(
      "<ul><li>Pixels that are not finite: <b>{}</b>, in {} frames.</li><li>R1 with half its shells differs "
      "from R1 by at most {:.4f}. The smallest error is {:.4f}. {}</li></ul>",
      broken, rows.size(), floor, min, verdict);
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
  Table table{{"scene", "setting", "truth", "error", "95%", "silhouette", "ms", "CPU ms"}, {}};
  for (const Row& row : rows) {
    table.rows.push_back({row.scene, name_of(row), row.reference, fmt::format("{:.4f}", row.flip),
                          fmt::format("{:.3f}", row.flip_95), fmt::format("{:.4f}", row.silhouette),
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
