// Example lines for each command, shown in its help and on the manual page.
#pragma once

#include <string>
#include <vector>

namespace pelage {

inline constexpr const char* exit_codes = "0 done, 1 failed, 2 wrong use, 3 the input was refused.";

/// Returns shell lines that use a command, such as "map get"; "" stands for the program.
std::vector<std::string> examples_of(const std::string& command);

/// Returns the text that is printed below a command's help.
std::string footer_of(const std::string& command);

}  // namespace pelage
