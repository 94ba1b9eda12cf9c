// The initial groom of a model.
#pragma once

#include "protocol/commands/scene.h"
#include "server/fields/field_set.h"
#include "server/groom/cancel.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Returns fields with fur that leans along fur_flow (fur_flow.h) and stands upright where the flow begins, ends or
/// parts. Lengths follow the mesh's length scale, and vertices whose materials are bare are bare. -0 is stored as 0.
/// Throws Cancelled.
FieldSet first_groom(const Mesh& mesh, const FirstGroom& fur, const Cancel& cancel = {});

}  // namespace pelage
