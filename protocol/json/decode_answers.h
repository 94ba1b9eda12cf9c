// What a client reads of the server's answers. Members and words that are new are passed over, and limits may have
// grown, so that an older client lives on.
#pragma once

#include <string_view>

#include "protocol/base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/map.h"
#include "protocol/commands/quality.h"

namespace pelage {

/// Refuses (malformed, with the pointer of the bad member) what is no such answer. T is a struct that encode.h makes an
/// answer of.
template <class T>
Result<T> decode_answer(std::string_view text);

/// The refusal in a problem document; its code follows the `type`. Malformed when it is no problem document.
Status decode_problem(std::string_view text);

}  // namespace pelage
