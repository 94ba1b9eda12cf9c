// One function for each tool, each in its own file. Commands are resolved; formulas are those of docs and science.
#pragma once

#include "protocol/commands/command.h"
#include "server/groom/evaluate.h"

namespace pelage {

Evaluation comb(const Comb& command, const Surface& surface, const FieldSet& fields);
Evaluation blow(const Blow& command, const Surface& surface, const FieldSet& fields);
Evaluation attract(const Attract& command, const Surface& surface, const FieldSet& fields);

}  // namespace pelage
