// How much work a command is, known before it begins: counted from what it asks for, never timed.
#pragma once

#include "base/status.h"
#include "protocol/commands/command.h"
#include "server/surface/surface.h"

namespace pelage {

/// Work in visits: one visit looks at one vertex once, the lightest thing that a tool does. The same command on the
/// same surface always costs the same.
struct EvaluationCost {
  double visits = 0;
  const char* field = "";  // JSON pointer to the field of the command that asks for most of it
};

/// An estimate for all images of a resolved command under the symmetry. `longest_fur`, in sizes, is how far brushes
/// that reach fur look around.
EvaluationCost evaluation_cost(const Command& resolved, const Symmetry& symmetry, const Surface& surface,
                               double longest_fur);

/// How many images a symmetry has of a command with places, itself included.
double image_count(const Symmetry& symmetry);

/// Counts a command to those before it in its batch, in `visits`. Refused (invalid) beyond limits::evaluation_visits.
Status add_cost(const Command& resolved, const Symmetry& symmetry, const Surface& surface, double longest_fur,
                double& visits);

}  // namespace pelage
