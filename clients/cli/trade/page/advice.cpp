#include "clients/cli/trade/page/advice.h"

#include <fmt/format.h>

#include <algorithm>

#include "clients/cli/trade/page/html.h"
#include "clients/cli/trade/page/svg.h"

namespace pelage::trade {

namespace {

constexpr double no_worse = 1.02;  // measured costs differ by so much from run to run

std::string ms(double value) { return milliseconds(value); }
std::string error(double value) { return fmt::format("{:.4f}", value); }

std::vector<std::string> cells_of(std::string wish, const std::optional<Mean>& choice) {
  if (!choice) return {std::move(wish), "nothing that was measured", "", "", ""};
  return {std::move(wish), choice->name, ms(choice->cost), error(choice->flip), error(choice->outline)};
}

std::string budget_table(const std::vector<Mean>& settings) {
  Table table{{"so many ms", "choose", "ms", "error", "outline"}, {}};
  const auto [least, most] = std::minmax_element(settings.begin(), settings.end(),
                                                 [](const Mean& a, const Mean& b) { return a.cost < b.cost; });
  std::string last;
  for (const double budget : {1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000}) {
    const std::optional<Mean> choice = best_within(settings, budget);
    if (budget < least->cost || budget > 2 * most->cost || choice->name == last) continue;  // more time buys nothing
    table.rows.push_back(cells_of(ms(budget), choice));
    last = choice->name;
  }
  return table_html(table);
}

std::string error_table(const std::vector<Mean>& settings) {
  Table table{{"error of at most", "choose", "ms", "error", "outline"}, {}};
  for (const double wish : {0.08, 0.04, 0.03, 0.02, 0.015})
    table.rows.push_back(cells_of(fmt::format("{:.3f}", wish), cheapest_at(settings, wish)));
  return table_html(table);
}

/// Whether another setting is as cheap and better, in words.
std::string judgement(const std::vector<Mean>& settings, const Mean& tier) {
  const std::optional<Mean> better = best_within(settings, tier.cost * no_worse);
  const std::string start = fmt::format("<b>{}</b> takes {} ms with an error of {} (outline {}). ", escaped(tier.name),
                                        ms(tier.cost), error(tier.flip), error(tier.outline));
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
      ".08 is seen side by side. The error is of layers, not of light: fur drawn without self-shadow is measured "
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
