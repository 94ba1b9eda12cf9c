// Completion scripts for bash, zsh and fish.
#pragma once

#include <string>

#include "clients/cli/help/command_tree.h"

namespace pelage {

// The scripts complete commands, the options of the current command, option values and scene names; else file names.

std::string bash_completions(const CommandHelp& root);
std::string zsh_completions(const CommandHelp& root);
std::string fish_completions(const CommandHelp& root);

}  // namespace pelage
