// Estimates the work of a command before it runs. The estimate is counted, never timed.
#pragma once

#include "base/status.h"
#include "protocol/commands/command.h"
#include "server/surface/surface.h"

namespace pelage {

/// Work in visits. One visit reads one vertex once, the cheapest operation of a tool. The same command on the same
/// surface always costs the same.
struct EvaluationCost {
  double visits = 0;
  const char* field = "";  // JSON pointer to the field of the command that causes most of the work
};

/// Returns the estimate for all symmetry images of a resolved command. `longest_fur`, in sizes, is the search distance
/// of brushes that reach for fur.
EvaluationCost evaluation_cost(const Command& resolved, const Symmetry& symmetry, const Surface& surface,
                               double longest_fur);

/// Returns the number of images of a command with positions under a symmetry, the command itself included.
double image_count(const Symmetry& symmetry);

/// Adds the cost of a command to `visits`, the cost of those before it in its batch. Refuses (invalid) more than
/// limits::evaluation_visits.
Status add_cost(const Command& resolved, const Symmetry& symmetry, const Surface& surface, double longest_fur,
                double& visits);

}  // namespace pelage
