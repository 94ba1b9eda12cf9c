// What the images of a command do where they overlap.
#pragma once

#include <span>

#include "server/fields/field_set.h"

namespace pelage {

/// Combines changes of the visible values that all start from `fields`. A vertex that one change reaches takes that
/// change; where several do, it takes their mean, weighted by the length of each. So equal images change nothing twice,
/// a stroke on a plane of symmetry does what it does without, and what two images do beside each other is mirrored to
/// the bit.
FieldDelta together(std::span<const FieldDelta> images, const FieldSet& fields);

}  // namespace pelage
