// The command line as data: what completions and manual pages are made of.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace pelage {

struct OptionHelp {
  std::vector<std::string> names;  // "-o", "--output"; of a positional argument its one name without dashes
  std::string words;               // what it does
  std::string preset;              // its default; "" where its words say it
  bool takes_value = false;
  bool required = false;
};

struct CommandHelp {
  std::string name;   // "" for the program, else such as "map get"
  std::string words;  // what it does
  std::vector<OptionHelp> arguments;
  std::vector<OptionHelp> options;
  std::vector<CommandHelp> commands;  // below it
};

CommandHelp tree_of(const CLI::App& app);

/// A command and all below it, itself first.
std::vector<const CommandHelp*> all_commands(const CommandHelp& root);

}  // namespace pelage
