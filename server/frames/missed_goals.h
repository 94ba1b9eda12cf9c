// What a picture did not keep of its request.
#pragma once

#include <string>

#include "protocol/commands/frame.h"

namespace pelage {

struct FrameAnswer;

/// Names of the request's members that the picture missed, with ", " between them; "" where it kept all. `budget_ms`
/// and `seconds` of tracing are missed where more than budget_margin times as much passed, `max_error` where no knobs
/// are known that keep it.
std::string missed_goals(const FrameRequest& request, const FrameAnswer& answer);

}  // namespace pelage
