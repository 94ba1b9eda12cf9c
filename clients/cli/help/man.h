// Generates the manual page.
#pragma once

#include <string>

#include "clients/cli/help/command_tree.h"

namespace pelage {

/// Returns one page about the program and all its commands, in roff format for `man`.
std::string man_page(const CommandHelp& root, const std::string& version);

}  // namespace pelage
