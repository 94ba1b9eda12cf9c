#include "clients/cli/help/command_tree.h"

#include <CLI/CLI.hpp>

namespace pelage {

namespace {

OptionHelp help_of(const CLI::Option& option) {
  OptionHelp help{
      {}, option.get_description(), option.get_default_str(), option.get_expected() > 0, option.get_required()};
  if (option.get_positional()) help.names = {option.get_name(true)};
  if (option.nonpositional()) help.names.clear();
  for (const std::string& name : option.get_snames()) help.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) help.names.push_back("--" + name);
  return help;
}

CommandHelp help_of(const CLI::App& app, const std::string& name) {
  CommandHelp help{name, app.get_description(), {}, {}, {}};
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; }))
    (option->nonpositional() ? help.options : help.arguments).push_back(help_of(*option));
  for (const CLI::App* subcommand : app.get_subcommands([](const CLI::App*) { return true; }))
    help.commands.push_back(help_of(*subcommand, (name.empty() ? "" : name + " ") + subcommand->get_name()));
  return help;
}

}  // namespace

CommandHelp tree_of(const CLI::App& app) { return help_of(app, ""); }

std::vector<const CommandHelp*> all_commands(const CommandHelp& root) {
  std::vector<const CommandHelp*> all{&root};
  for (const CommandHelp& subcommand : root.commands) {
    const std::vector<const CommandHelp*> more = all_commands(subcommand);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace pelage
