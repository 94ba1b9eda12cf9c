// Draws one scene with all settings and measures them.
#pragma once

#include <functional>
#include <vector>

#include "clients/cli/session.h"
#include "clients/cli/trade/cases.h"
#include "clients/cli/trade/page/page.h"

namespace pelage::trade {

struct SweepOptions {
  bool quick = false;
  int size = 256;   // pixels of a side
  int truth = 512;  // shells of R1
  int passes = 64;  // of R2
  int repeats = 2;  // of which the least time counts
};

/// How much work a sweep is, in frames of usual cost.
double work_of(const Case& scene, const SweepOptions& options);

/// Adds the rows and pictures of this scene to the report. Rows of the same scene, size, truth and knobs that it has
/// already are kept and not drawn again; those of others that would be mixed with them go. `done` hears of work as it
/// is done, and may store what there is. A scene that is made for it is removed again, also when something fails.
Status sweep(Session& session, const Case& scene, const SweepOptions& options, Report& report,
             const std::function<Status(double work)>& done);

}  // namespace pelage::trade
