#include "server/scene/check_cost.h"

#include "server/groom/evaluation_cost.h"

namespace pelage {

Status check_cost(const std::vector<Step>& steps, Symmetry symmetry, const Surface& surface) {
  double visits = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (const auto* set = std::get_if<SetSymmetry>(&steps[k].command)) symmetry = set->symmetry;
    if (Status refused = add_cost(steps[k].command, symmetry, surface, visits); !refused.ok())
      return in_batch(refused, k, steps.size());
  }
  return {};
}

}  // namespace pelage
