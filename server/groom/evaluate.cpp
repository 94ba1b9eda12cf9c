#include "server/groom/evaluate.h"

#include <cassert>

#include "server/groom/tools.h"

namespace pelage {

namespace {

/// Calls the tool of a command; commands that set something about the scene change no field.
struct Tools {
  const Surface& surface;
  const FieldSet& fields;
  const ToolExtras& extras;

  Evaluation operator()(const Comb& command) const { return comb(command, surface, fields); }
  Evaluation operator()(const Blow& command) const { return blow(command, surface, fields); }
  Evaluation operator()(const Attract& command) const { return attract(command, surface, fields); }
  Evaluation operator()(const Interpolate& command) const { return interpolate(command, surface, fields); }
  Evaluation operator()(const Flow& command) const { return flow(command, surface, fields); }
  Evaluation operator()(const Smooth& command) const { return smooth(command, surface, fields); }
  Evaluation operator()(const Noise& command) const { return noise(command, surface, fields); }
  Evaluation operator()(const Unify& command) const { return unify(command, surface, fields); }
  Evaluation operator()(const Part& command) const { return part(command, surface, fields); }
  Evaluation operator()(const Length& command) const { return length(command, surface, fields); }
  Evaluation operator()(const Trim& command) const { return trim(command, surface, fields, extras.coat); }
  Evaluation operator()(const Lift& command) const { return lift(command, surface, fields); }
  Evaluation operator()(const Erase& command) const {
    assert(extras.baseline != nullptr);
    return erase(command, surface, fields, *extras.baseline);
  }
  Evaluation operator()(const Clump& command) const { return clump(command, surface, fields); }
  Evaluation operator()(const Curl& command) const { return curl(command, surface, fields); }
  Evaluation operator()(const Paint& command) const { return paint(command, surface, fields); }
  Evaluation operator()(const ChangeMask& command) const { return mask(command, surface, fields, extras.picture); }
  Evaluation operator()(const ApplyMap& command) const {
    assert(extras.picture != nullptr);
    return map(command, surface, fields, *extras.picture);
  }
  Evaluation operator()(const Retarget& command) const {
    assert(extras.source != nullptr && extras.baseline != nullptr);
    return retarget(command, surface, fields, *extras.source, *extras.baseline);
  }
  template <class Setting>
  Evaluation operator()(const Setting&) const {
    return {};
  }
};

}  // namespace

Evaluation evaluate(const Command& resolved, const Surface& surface, const FieldSet& fields, const ToolExtras& extras) {
  return std::visit(Tools{surface, fields, extras}, resolved);
}

}  // namespace pelage
