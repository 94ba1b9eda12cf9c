// Combs whose strokes, or parts of strokes, differ by their positions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "protocol/commands/command.h"

namespace pelage {

inline Comb comb_at(double x, std::string id = {}, std::uint32_t part = 0, bool last = true) {
  Comb comb;
  comb.stroke = Stroke{std::move(id), part, last, {}, std::nullopt};
  for (const double y : {0.0, 0.1}) {
    StrokeSample sample;
    sample.position = PositionSample{{x, y, 0}};
    comb.stroke->samples.push_back(sample);
  }
  return comb;
}

}  // namespace pelage
