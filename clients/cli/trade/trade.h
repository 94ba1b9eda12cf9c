// What `pelage trade` does: measures what each quality costs and how far it is from the truth, and writes a report.
#pragma once

#include "clients/cli/session.h"

namespace pelage {

/// Draws scenes on the server with many knobs, and writes results.csv and index.html into the folder that the options
/// name. Scenes that it makes itself are removed again; those of the user are only looked at.
ExitCode measure_trade(Session& session);

}  // namespace pelage
