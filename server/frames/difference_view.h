// What two states of the fields differ in, as one number for each vertex.
#pragma once

#include <vector>

#include "server/fields/field_set.h"

namespace pelage {

/// For each vertex the largest over all fields of |change| / what counts as much, held at 1: 1 for direction and
/// colours (the length of the difference), the longest fur of either state for length, the range for other fields.
/// Above 0 wherever any value differs, and 0 elsewhere. Both have the same vertices.
std::vector<float> change_shares(const FieldSet& from, const FieldSet& to);

}  // namespace pelage
