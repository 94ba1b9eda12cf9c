#include "server/groom/evaluate.h"

#include "server/groom/tools.h"

namespace pelage {

namespace {

/// Calls the tool of a command; commands that set something about the scene change no field.
struct Tools {
  const Surface& surface;
  const FieldSet& fields;

  Evaluation operator()(const Comb& command) const { return comb(command, surface, fields); }
  Evaluation operator()(const Blow& command) const { return blow(command, surface, fields); }
  Evaluation operator()(const Attract& command) const { return attract(command, surface, fields); }
  Evaluation operator()(const SetCoat&) const { return {}; }
  Evaluation operator()(const SetLook&) const { return {}; }
  Evaluation operator()(const SetLights&) const { return {}; }
  Evaluation operator()(const SetEyes&) const { return {}; }
};

}  // namespace

Evaluation evaluate(const Command& resolved, const Surface& surface, const FieldSet& fields) {
  return std::visit(Tools{surface, fields}, resolved);
}

}  // namespace pelage
