#include "protocol/commands/frame.h"

#include <cassert>

namespace pelage {

Knobs knobs_of(Tier tier) {
  switch (tier) {
    case Tier::draft: return {.eye_steps = 1, .raster = {.strands = 0.4, .light_of = 4}};
    case Tier::interactive: return {};
    case Tier::detailed: return {.scale = 2, .eye_steps = 16, .raster = {.strands = 1000, .light_of = 3}};
    case Tier::reference: return {.method = Method::strands, .eye_steps = 16};
  }
  assert(false);
  return {};
}

int lossy_quality(const Knobs& knobs) {
  if (knobs.method != Method::raster || knobs.scale > 1) return 94;
  return knobs.raster.strands < 1 ? 80 : 88;
}

}  // namespace pelage
