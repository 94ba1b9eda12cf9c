// The colour spaces that LDR-FLIP works in. Linear RGB has sRGB's primaries and white (D65); values are in [0, 1].
#pragma once

#include <glm/glm.hpp>

namespace pelage {

/// Rec. 709 luminance.
double luminance_of(const glm::dvec3& linear);

/// The linearised opponent space of Zhang and Wandell (1996): Y in [-16, 100], Cx red against green, Cz blue against
/// yellow.
glm::dvec3 ycxcz_from_linear(const glm::dvec3& linear);

/// Back, held to the colours that a display has.
glm::dvec3 linear_from_ycxcz(const glm::dvec3& ycxcz);

/// CIE L*a*b* with a and b scaled by L / 100 (Hunt: colourfulness grows with luminance; Andersson et al. 2020, eq. 5).
glm::dvec3 hunt_lab_from_linear(const glm::dvec3& linear);

/// |dL| + |(da, db)| (Abasi et al. 2020), for large differences of colour.
double hyab(const glm::dvec3& first, const glm::dvec3& second);

}  // namespace pelage
