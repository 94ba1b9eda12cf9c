// The plots of the report, each an svg. Rows that are not against R1 are passed over.
#pragma once

#include <string>
#include <vector>

#include "clients/cli/trade/page/row.h"

namespace pelage::trade {

/// Error against cost of every setting on one scene, with the Pareto front and the tiers (scatter.cpp).
std::string scatter_plot(const std::vector<Row>& rows, const std::string& scene);

/// One small plot for each knob: the way that turning it takes through error and cost on one scene (multiples.cpp).
std::string knob_plots(const std::vector<Row>& rows, const std::string& scene);

/// Where the tiers' errors lie on every scene, over the fur and in its outline (tiers.cpp).
std::string tier_plot(const std::vector<Row>& rows);

/// Error against the number of shells on every scene, with fitted slopes (convergence.cpp).
std::string convergence_plot(const std::vector<Row>& rows);

}  // namespace pelage::trade
