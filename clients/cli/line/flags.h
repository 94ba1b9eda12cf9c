// What the members of a request are called on the command line.
#pragma once

#include <map>
#include <string>

namespace CLI {
class App;
}

namespace pelage {

/// The flag, or the argument's name, of the command that the line names, by the last step of the JSON pointer of the
/// member that it gives. Nothing for commands whose pointers lead into a file.
std::map<std::string, std::string> flags_of(const CLI::App& app);

}  // namespace pelage
