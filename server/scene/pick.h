// What lies under a pixel.
#pragma once

#include "protocol/commands/answers.h"
#include "protocol/commands/frame.h"
#include "server/fields/field_set.h"
#include "server/surface/surface.h"

namespace pelage {

/// The nearest hit of the pixel's ray, with the fields between the corners of its triangle.
PickAnswer pick(const Surface& surface, const FieldSet& fields, const View& view, glm::dvec2 pixel);

}  // namespace pelage
