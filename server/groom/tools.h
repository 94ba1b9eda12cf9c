// One function for each tool, each in its own file. Commands are resolved; formulas are those of docs and science.
#pragma once

#include "protocol/commands/command.h"
#include "server/groom/evaluate.h"

namespace pelage {

Evaluation comb(const Comb& command, const Surface& surface, const FieldSet& fields);
Evaluation blow(const Blow& command, const Surface& surface, const FieldSet& fields);
Evaluation attract(const Attract& command, const Surface& surface, const FieldSet& fields);
Evaluation interpolate(const Interpolate& command, const Surface& surface, const FieldSet& fields);
Evaluation flow(const Flow& command, const Surface& surface, const FieldSet& fields);
Evaluation smooth(const Smooth& command, const Surface& surface, const FieldSet& fields);
Evaluation noise(const Noise& command, const Surface& surface, const FieldSet& fields);
Evaluation unify(const Unify& command, const Surface& surface, const FieldSet& fields);
Evaluation part(const Part& command, const Surface& surface, const FieldSet& fields);
Evaluation length(const Length& command, const Surface& surface, const FieldSet& fields);
Evaluation trim(const Trim& command, const Surface& surface, const FieldSet& fields, const Coat& coat);
Evaluation lift(const Lift& command, const Surface& surface, const FieldSet& fields);
Evaluation erase(const Erase& command, const Surface& surface, const FieldSet& fields, const FieldSet& baseline);
Evaluation clump(const Clump& command, const Surface& surface, const FieldSet& fields);
Evaluation curl(const Curl& command, const Surface& surface, const FieldSet& fields);
Evaluation paint(const Paint& command, const Surface& surface, const FieldSet& fields);
Evaluation mask(const ChangeMask& command, const Surface& surface, const FieldSet& fields,
                const MapPicture* picture = nullptr);
Evaluation map(const ApplyMap& command, const Surface& surface, const FieldSet& fields, const MapPicture& picture);
Evaluation retarget(const Retarget& command, const Surface& surface, const FieldSet& fields, const Surface& source,
                    const FieldSet& source_fields);

}  // namespace pelage
