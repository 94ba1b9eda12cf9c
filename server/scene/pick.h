// Which place of the surface is meant, and the fur there.
#pragma once

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/pick.h"
#include "server/fields/field_set.h"
#include "server/surface/surface.h"

namespace pelage {

/// The place, with the fields between the corners of its triangle. No hit where a ray passes by, or no part of the
/// surface lies in the box. Refuses places that lie too far from the model, as commands do.
Result<PickAnswer> pick(const Surface& surface, const FieldSet& fields, const PickRequest& wanted);

}  // namespace pelage
