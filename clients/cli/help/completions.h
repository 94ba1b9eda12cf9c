// Scripts that complete the command line in a shell.
#pragma once

#include <string>

#include "clients/cli/help/command_tree.h"

namespace pelage {

// Commands, and the options of the command that is being written; elsewhere names of files.

std::string bash_completions(const CommandHelp& root);
std::string zsh_completions(const CommandHelp& root);
std::string fish_completions(const CommandHelp& root);

}  // namespace pelage
