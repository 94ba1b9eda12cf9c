// Which place of the surface is meant, and the fur there.
#pragma once

#include "protocol/commands/answers.h"
#include "protocol/commands/pick.h"
#include "server/fields/field_set.h"
#include "server/surface/surface.h"

namespace pelage {

/// The place, with the fields between the corners of its triangle. No hit where a ray passes by, or no part of the
/// surface lies in the box.
PickAnswer pick(const Surface& surface, const FieldSet& fields, const PickRequest& wanted);

}  // namespace pelage
