// Guide curves as keys of an interpolation.
#pragma once

#include <cstddef>
#include <vector>

#include "protocol/commands/coat.h"
#include "protocol/commands/creature.h"
#include "protocol/commands/tools.h"
#include "server/surface/surface.h"

namespace pelage {

/// Roots of guides are taken to stand on the skin up to so many sizes from it.
inline constexpr double guide_reach = 0.05;

struct GuideKeys {
  std::vector<Key> keys;  // model coordinates; lengths in sizes
  std::size_t far = 0;    // curves left out: their roots stand off the skin
};

/// A key for each curve, which are in model coordinates: the direction and inclination of a strand of the coat whose
/// tip lies as the curve's does, seen from the root, and the length of the curve. At most as inclined as strands can
/// be.
GuideKeys keys_of(const std::vector<GuideCurve>& curves, const Surface& surface, const Coat& coat);

/// `count` of the keys, evenly by their order.
std::vector<Key> thinned(const std::vector<Key>& keys, std::size_t count);

/// Gaussians that reach from key to key, sizes: by the mean area of the surface that each has.
double sigma_between(std::size_t keys, const Mesh& mesh);

}  // namespace pelage
