// Combines the changes of a command's symmetry images where they overlap.
#pragma once

#include <span>

#include "server/fields/field_set.h"

namespace pelage {

/// Combines changes of the visible values that all start from `fields`. A vertex changed by one image takes that
/// change; one changed by several takes their mean, weighted by the magnitude of each. So equal images do not change
/// anything twice, a stroke on a plane of symmetry gives the same result as without symmetry, and the combined result
/// is mirror symmetric to the bit.
FieldDelta combine_symmetry_images(std::span<const FieldDelta> images, const FieldSet& fields);

}  // namespace pelage
