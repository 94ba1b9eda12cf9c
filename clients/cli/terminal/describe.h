// Commands in a few words, for people.
#pragma once

#include <string>

namespace pelage {

/// "comb r 0.12" of a log entry's commands, as JSON; several with commas, and more than three as their number. Empty
/// where there are none.
std::string described(const std::string& commands);

}  // namespace pelage
