// The manual page.
#pragma once

#include <string>

#include "clients/cli/help/command_tree.h"

namespace pelage {

/// The page of the program and of each command below it, as roff for `man`.
std::string man_page(const CommandHelp& root, const std::string& version);

}  // namespace pelage
