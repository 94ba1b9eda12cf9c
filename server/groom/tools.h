// One function for each tool, each in its own file. The formulas are those of docs and science; commands are resolved.
// A tool of tool_list.h without such a function does not compile.
#pragma once

#include <concepts>

#include "protocol/commands/command.h"
#include "server/groom/evaluate.h"

namespace pelage {

Evaluation run(const Comb& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Blow& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Attract& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Interpolate& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Flow& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Smooth& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Noise& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Unify& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Part& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Whorl& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Length& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Trim& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Lift& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Erase& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Clump& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Curl& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Paint& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const ChangeMask& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const ApplyMap& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);
Evaluation run(const Retarget& command, const Surface& surface, const FieldSet& fields, const ToolExtras& extras);

/// The requirement of evaluate() on every tool of tool_list.h.
template <class Tool>
concept Runnable = requires(const Tool& tool, const Surface& surface, const FieldSet& fields,
                            const ToolExtras& extras) {
  { run(tool, surface, fields, extras) } -> std::same_as<Evaluation>;
};

}  // namespace pelage
