// The fields that a model begins with.
#pragma once

#include "protocol/commands/scene.h"
#include "server/fields/field_set.h"
#include "server/groom/cancel.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Returns fur that leans along fur_flow (fur_flow.h) and stands up where the flow begins, ends and parts, with the
/// mesh's length scale, and bare where the mesh's materials are; -0 is stored as 0. Throws Cancelled.
FieldSet first_groom(const Mesh& mesh, const FirstGroom& fur, const Cancel& cancel = {});

}  // namespace pelage
