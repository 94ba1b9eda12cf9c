// Where a tool that visits each vertex once works, and how strongly.
#pragma once

#include <optional>
#include <vector>

#include "server/groom/brush.h"

namespace pelage {

enum class Masked { yes, no };

/// Under the stroke the largest weight of any dab; without one everywhere the brush's strength. Times the mask, unless
/// it is the mask itself that is painted. Rising vertices with weights above 0. Throws Cancelled.
std::vector<VertexWeight> region_of(const std::optional<Stroke>& stroke, const Brush& brush, const Surface& surface,
                                    const FieldSet& fields, const Cancel& cancel, Masked masked = Masked::yes);

/// How much of a field lies in the part of the strand that the brush changes: of the root's colour, which stands for
/// the lower half, or the tip's, which stands for the upper. Others have one value for the whole strand: 1.
double strand_share(const Brush& brush, Field field);

}  // namespace pelage
