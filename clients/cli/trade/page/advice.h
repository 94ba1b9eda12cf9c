// What to choose when, from what was measured.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "clients/cli/trade/page/front.h"

namespace pelage::trade {

/// The setting with the least error that costs at most so many milliseconds.
std::optional<Mean> best_within(const std::vector<Mean>& settings, double milliseconds);

/// The cheapest setting with at most this error.
std::optional<Mean> cheapest_at(const std::vector<Mean>& settings, double error);

/// The section as HTML: two tables, and sentences on the tiers.
std::string advice_html(const std::vector<Row>& rows);

}  // namespace pelage::trade
