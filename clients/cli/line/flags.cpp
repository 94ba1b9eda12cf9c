#include "clients/cli/line/flags.h"

#include <CLI/CLI.hpp>
#include <algorithm>

namespace pelage {

namespace {

/// Flags, and the member that each one sets, where the flag's name is not that of the member.
constexpr std::pair<const char*, const char*> member_aliases[] = {
    {"--fov", "fov_degrees"}, {"--from", "overlay_from"}, {"--camera", "auto"}, {"x", "pixel"},
    {"--box", "min"},         {"--box", "max"},           {"step", "revision"}, {"--until-pass", "after_pass"}};

bool has_pointers_into_a_file(const CLI::App& command) {
  return command.get_name() == "run" || command.get_name() == "amend";
}

void add_flags(const CLI::App& command, std::map<std::string, std::string>& flags) {
  for (const CLI::Option* option : command.get_options([](const CLI::Option*) { return true; })) {
    const std::string flag = option->nonpositional() ? "--" + option->get_lnames().front() : option->get_name(true);
    std::string member = flag.substr(flag.find_first_not_of('-'));
    std::replace(member.begin(), member.end(), '-', '_');
    flags[member] = flag;
    for (const auto& [other, name] : member_aliases)
      if (flag == other) flags[name] = flag;
  }
}

}  // namespace

std::map<std::string, std::string> flags_of(const CLI::App& app) {
  std::map<std::string, std::string> flags;
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
  if (!has_pointers_into_a_file(*command)) add_flags(*command, flags);
  return flags;
}

}  // namespace pelage
