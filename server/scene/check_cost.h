// Whether commands are too much work, before any of them begins.
#pragma once

#include <vector>

#include "server/scene/batch.h"

namespace pelage {

/// Refused (invalid) when the commands are too much work together; those before one may change its symmetry.
Status check_cost(const std::vector<Step>& steps, Symmetry symmetry, const Surface& surface);

}  // namespace pelage
