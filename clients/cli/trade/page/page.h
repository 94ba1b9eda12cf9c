// What is worth its cost: the Pareto front, means over scenes, and slopes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/cli/trade/page/row.h"

namespace pelage::trade {

/// A setting over all scenes that have it.
struct Mean {
  std::string name;                 // of the setting in words
  std::string knobs;                // JSON
  double cost = 0;                  // milliseconds, geometric mean
  double flip = 0, silhouette = 0;  // means
  int scenes = 0;
};

/// Drawing milliseconds of CPU where the server says them, else of wall time.
double cost_of(const Row& row);

/// Three digits, without an exponent.
std::string milliseconds(double value);

/// Whether the row is against R1, with any shadows.
bool against_shells(const Row& row);

/// In words: "interactive", "interactive with 8 shells", "8 shells of 3 steps at 0.75 of the size".
std::string name_of(const Row& row);

/// Indices of points that no other point beats in both, by rising cost. Of equal points the first stays.
std::vector<std::size_t> pareto_front(const std::vector<double>& costs, const std::vector<double>& errors);

/// Settings that every one of `scenes` has, against R1, each once, in the order of the rows.
std::vector<Mean> means_over(const std::vector<Row>& rows, const std::vector<std::string>& scenes);

/// Scenes with a grid of settings, in the order of the rows; and all of them.
std::vector<std::string> swept_scenes(const std::vector<Row>& rows);
std::vector<std::string> all_scenes(const std::vector<Row>& rows);

/// The p that fits y = c / x^p in least squares of logarithms; none with fewer than 2 different x. All above 0.
std::optional<double> fitted_order(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace pelage::trade

// What to choose when, from what was measured.

namespace pelage::trade {

/// The setting with the least error that costs at most so many milliseconds.
std::optional<Mean> best_within(const std::vector<Mean>& settings, double milliseconds);

/// The cheapest setting with at most this error.
std::optional<Mean> cheapest_at(const std::vector<Mean>& settings, double error);

/// The section as HTML: two tables, and sentences on the tiers.
std::string advice_html(const std::vector<Row>& rows);

}  // namespace pelage::trade

// The report as one HTML page.

namespace pelage::trade {

/// A small picture with its error map, where there is one.
struct Picture {
  std::string scene;
  std::string name;     // "R1", "draft", ...
  std::string caption;  // its figures
  std::string jpeg;     // bytes
  std::string map;      // bytes of a JPEG; "" for none
};

struct Report {
  std::string renderer;  // what drew: the GL's name of itself
  int size = 0;          // pixels of a side
  int repeats = 1;       // of which the least time counts
  int truth = 512;       // shells of R1
  std::vector<Row> rows;
  std::vector<Picture> pictures = {};
};

/// Bytes as base64 (RFC 4648).
std::string base64(const std::string& bytes);

/// The whole page; it needs nothing beside itself.
std::string page(const Report& report);

}  // namespace pelage::trade
