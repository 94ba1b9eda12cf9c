#include "protocol/commands/frame.h"

#include <cassert>

namespace pelage {

Knobs knobs_of(Tier tier) {
  switch (tier) {
    case Tier::draft: return {.shells = 8, .steps = 4, .scale = 0.6, .min_radius = 120, .eye_steps = 1};
    case Tier::interactive: return {};
    case Tier::detailed:
      return {.shells = 32,
              .scale = 2,
              .eye_steps = 16,
              .shadow_maps = true,
              .shadow_resolution = 1024,
              .order = FragmentOrder::sorted};
    case Tier::reference: return {.eye_steps = 16, .method = Method::strands};
  }
  assert(false);
  return {};
}

}  // namespace pelage
