// Maps the members of a request to the flags that set them.
#pragma once

#include <map>
#include <string>

namespace CLI {
class App;
}

namespace pelage {

/// Returns the flags and argument names of the command on the line. The key is the member that a flag sets: the last
/// component of its JSON pointer. Empty for commands whose errors point into a file (run, amend).
std::map<std::string, std::string> flags_of(const CLI::App& app);

}  // namespace pelage
