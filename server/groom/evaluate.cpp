#include "server/groom/evaluate.h"

#include "server/groom/tools.h"

namespace pelage {

namespace {

/// Calls the tool of a command. Settings change no field; there is no third kind.
struct Run {
  const Surface& surface;
  const FieldSet& fields;
  const ToolExtras& extras;

  template <ToolCommand Tool>
  Evaluation operator()(const Tool& tool) const {
    static_assert(Runnable<Tool>, "a tool of tool_list.h has no run() in server/groom/tools.h");
    extras.cancel.check();
    return run(tool, surface, fields, extras);
  }
  template <SettingCommand Setting>
  Evaluation operator()(const Setting&) const {
    return {};
  }
};

}  // namespace

Evaluation evaluate(const Command& resolved, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  return std::visit(Run{surface, fields, extras}, resolved);
}

}  // namespace pelage
