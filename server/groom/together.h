// What the images of a command do where they overlap.
#pragma once

#include <span>

#include "server/fields/field_set.h"

namespace pelage {

/// One change of what is seen, from changes that all start from `fields`: where one of them reaches it is that one, and
/// where several do their mean, in which each counts by its own length. So equal images change nothing twice, a stroke
/// on a plane of symmetry does what it does without, and what two of them do beside each other is mirrored to the bit.
FieldDelta together(std::span<const FieldDelta> images, const FieldSet& fields);

}  // namespace pelage
