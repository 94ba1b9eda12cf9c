// What the members of a request are called on the command line.
#pragma once

#include <map>
#include <string>

namespace CLI {
class App;
}

namespace pelage {

/// Returns the flags, or names of arguments, of the command on the line, by the last step of the JSON pointer of the
/// member that each sets. Empty for commands whose pointers lead into a file.
std::map<std::string, std::string> flags_of(const CLI::App& app);

}  // namespace pelage
