// Picks a position of the surface and reads the fur there.
#pragma once

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/pick.h"
#include "server/fields/field_set.h"
#include "server/surface/surface.h"

namespace pelage {

/// Returns the picked position, with the fields interpolated between the corners of its triangle. The answer is no hit
/// if the ray misses or no part of the surface lies in the box. Refuses positions too far from the model, as commands
/// do.
Result<PickAnswer> pick(const Surface& surface, const FieldSet& fields, const PickRequest& wanted);

}  // namespace pelage
