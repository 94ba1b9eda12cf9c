// Converts guide curves to keys of an interpolation.
#pragma once

#include <cstddef>
#include <vector>

#include "protocol/commands/coat.h"
#include "protocol/commands/creature.h"
#include "protocol/commands/tools.h"
#include "server/surface/surface.h"

namespace pelage {

/// Maximum distance of a guide's root from the skin, sizes.
inline constexpr double guide_reach = 0.05;

struct GuideKeys {
  std::vector<Key> keys;  // model coordinates; lengths in sizes
  std::size_t far = 0;    // number of curves left out because their roots are not on the skin
};

/// Returns a key for each curve, which is in model coordinates: the length of the curve, and the direction and
/// inclination of a strand of the coat whose tip lies in the direction of the curve's tip, seen from the root. The
/// inclination is limited to that of strands.
GuideKeys keys_of(const std::vector<GuideCurve>& curves, const Surface& surface, const Coat& coat);

/// Returns at most `count` of the keys, evenly spaced in their order.
std::vector<Key> thinned(const std::vector<Key>& keys, std::size_t count);

/// Returns the standard deviation of Gaussians that reach from key to key, sizes: the root of the mean area for a key.
double sigma_between(std::size_t keys, const Mesh& mesh);

}  // namespace pelage
