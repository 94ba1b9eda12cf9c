#include "clients/cli/help/man.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "clients/cli/help/examples.h"

namespace pelage {

namespace {

/// Escapes text for roff, so that no line is read as a request and dashes stay plain "-" when copied.
std::string roff_escaped(const std::string& text) {
  std::string escaped;
  if (text.starts_with('.') || text.starts_with('\'')) escaped = "\\&";
  for (const char c : text) {
    if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
  }
  return escaped;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::toupper(c); });
  return text;
}

std::string usage(const CommandHelp& command) {
  std::string line = "pelage " + command.name + (command.commands.empty() ? "" : " COMMAND") + " [OPTIONS]";
  for (const OptionHelp& argument : command.arguments) {
    const std::string name = upper(argument.names.front());
    line += argument.required ? " " + name : " [" + name + "]";
  }
  return ".B " + roff_escaped(line) + "\n";
}

std::string entry(const OptionHelp& option, bool positional) {
  std::string names;
  for (const std::string& name : option.names)
    names += (names.empty() ? "" : ", ") + (positional ? upper(name) : name) +
             (option.takes_value && !positional ? " VALUE" : "");
  const std::string default_value = option.default_value.empty() ? "" : " [" + option.default_value + "]";
  return ".TP\n.B " + roff_escaped(names) + "\n" + roff_escaped(option.words + default_value) + "\n";
}

std::string entries(const CommandHelp& command) {
  std::string all;
  for (const OptionHelp& argument : command.arguments) all += entry(argument, true);
  for (const OptionHelp& option : command.options)
    if (command.name.empty() || option.names.back() != "--help") all += entry(option, false);
  return all;
}

std::string examples(const std::string& name) {
  std::string all;
  for (const std::string& line : examples_of(name)) all += roff_escaped(line) + "\n";
  return all.empty() ? "" : ".nf\n.RS\n" + all + ".RE\n.fi\n";
}

}  // namespace

std::string man_page(const CommandHelp& root, const std::string& version) {
  std::string page = fmt::format(".TH PELAGE 1 \"\" \"{}\"\n.SH NAME\npelage \\- {}\n.SH SYNOPSIS\n", version,
                                 roff_escaped("grooms fur on a Pelage server"));
  page += usage(root) + ".SH OPTIONS\nThey may also follow the command.\n" + entries(root) + ".SH COMMANDS\n";
  for (const CommandHelp* command : all_commands(root)) {
    if (command->name.empty() || !command->commands.empty()) continue;
    page +=
        ".SS " + roff_escaped(command->name) + "\n" + usage(*command) + ".PP\n" + roff_escaped(command->words) + ".\n";
    page += entries(*command) + ".PP\nExamples:\n" + examples(command->name);
  }
  return page + ".SH EXAMPLES\n" + examples("") + ".SH EXIT STATUS\n" + roff_escaped(exit_codes) + "\n";
}

}  // namespace pelage
