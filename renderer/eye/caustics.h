// Light that a cornea gathers on the iris behind it.
#pragma once

#include <vector>

#include "renderer/eye/shape.h"

namespace pelage {

inline constexpr int caustic_texels = 48;     // across the iris, from -iris_radius to iris_radius
inline constexpr int caustic_angles = 20;     // of the light to the axis, from 0 to caustic_reach
inline constexpr double caustic_reach = 2.0;  // radians

/// For each angle, row by row, the irradiance on the plane of the iris over that of a surface which faces the light.
/// The light comes from +X. What comes through the cornea and reaches the iris is all there: the sum over texels times
/// a texel's area is the flux (science.md 5).
std::vector<float> gather_caustics(const EyeShape& shape);

}  // namespace pelage
