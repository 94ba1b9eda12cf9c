// The command line as data, from which shell completions and the manual page are generated.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pelage {

struct OptionHelp {
  std::vector<std::string> names;  // "-o", "--output"; a positional argument has one name without dashes
  std::string words;               // help text
  std::string default_value;       // "" if there is none or the help text states it
  bool takes_value = false;
  bool required = false;
};

struct CommandHelp {
  std::string name;   // full name, such as "map get"; "" for the program
  std::string words;  // help text
  std::vector<OptionHelp> arguments;
  std::vector<OptionHelp> options;
  std::vector<CommandHelp> commands;  // subcommands
};

CommandHelp tree_of(const CLI::App& app);

/// Returns a command and all its subcommands, recursively, parents first.
std::vector<const CommandHelp*> all_commands(const CommandHelp& root);

}  // namespace pelage
