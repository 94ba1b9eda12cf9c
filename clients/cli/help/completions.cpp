#include "clients/cli/help/completions.h"

#include <fmt/format.h>

#include <regex>

namespace pelage {

namespace {

/// Returns "get" for "map get".
std::string last_word(const std::string& name) { return name.substr(name.rfind(' ') + 1); }

/// Puts a text into single quotes for bash and zsh.
std::string shell_quoted(const std::string& text) {
  std::string in_quotes = "'";
  for (const char c : text) in_quotes += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return in_quotes + "'";
}

/// Puts a text into single quotes for fish.
std::string fish_quoted(const std::string& text) {
  std::string in_quotes = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') in_quotes += '\\';
    in_quotes += c;
  }
  return in_quotes + "'";
}

/// Returns the words that may follow a command, each with its help text: its subcommands, its own options, and the
/// program's options, which are valid anywhere.
std::vector<std::pair<std::string, std::string>> candidates_after(const CommandHelp& command, const CommandHelp& root) {
  std::vector<std::pair<std::string, std::string>> words;
  for (const CommandHelp& subcommand : command.commands)
    words.emplace_back(last_word(subcommand.name), subcommand.words);
  const auto add = [&](const CommandHelp& from) {
    for (const OptionHelp& option : from.options)
      for (const std::string& name : option.names) words.emplace_back(name, option.words);
  };
  add(command);
  if (&command == &root) return words;
  for (const OptionHelp& option : root.options)
    if (option.names.back() != "--help" && option.names.back() != "--version")
      for (const std::string& name : option.names) words.emplace_back(name, option.words);
  return words;
}

/// Returns the values of an option, separated by spaces, if its help text begins with a list such as "front, back or
/// left"; else "".
std::string values_of(const OptionHelp& option) {
  static const std::regex list(R"(^([\w-]+(?:, [\w-]+)* or [\w-]+)(?:$|[;,.]| \[).*)"), between(", | or ");
  std::smatch found;
  if (!option.takes_value || !std::regex_match(option.words, found, list)) return "";
  return std::regex_replace(found.str(1), between, " ");
}

bool begins_with_scene(const CommandHelp& command) {
  return !command.arguments.empty() && command.arguments.front().names == std::vector<std::string>{"scene"};
}

/// Returns branches of a bash or zsh `case` over "COMMAND OPTION". Each branch is the option's values between `before`
/// and `after`.
std::string value_cases(const CommandHelp& root, const std::string& before, const std::string& after) {
  std::string cases;
  for (const CommandHelp* command : all_commands(root))
    for (const OptionHelp& option : command->options)
      for (const std::string& name : option.names)
        if (const std::string values = values_of(option); !values.empty())
          cases += "    " + shell_quoted(command->name + " " + name) + ") " + before + values + after + "\n";
  return cases;
}

/// Returns a bash or zsh loop that sets `named` to the command on the line. `words` is the shell expression to loop
/// over.
std::string command_loop(const CommandHelp& root, const char* words) {
  std::string known;
  for (const CommandHelp* command : all_commands(root))
    if (!command->name.empty()) known += (known.empty() ? "" : " | ") + shell_quoted(command->name);
  return fmt::format(R"(  local named="" each
  for each in {}; do
    case "${{named:+$named }}$each" in
      {}) named="${{named:+$named }}$each" ;;
    esac
  done
)",
                     words, known);
}

/// Returns fish's condition, the argument of its option -n, that the command is on the line.
std::string fish_condition(const CommandHelp& command) {
  if (command.name.empty()) return "__fish_use_subcommand";
  std::string condition;
  std::string remaining = command.name + " ";
  for (std::size_t end; (end = remaining.find(' ')) != std::string::npos; remaining.erase(0, end + 1))
    condition += (condition.empty() ? "" : "; and ") + ("__fish_seen_subcommand_from " + remaining.substr(0, end));
  return condition;
}

std::string fish_option(const OptionHelp& option, const std::string& condition) {
  std::string line = "complete -c pelage";
  if (!condition.empty()) line += " -n " + fish_quoted(condition);
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  const std::string values = values_of(option);
  if (!values.empty()) line += " -f -a " + fish_quoted(values);
  return line + (option.takes_value ? " -r" : "") + " -d " + fish_quoted(option.words) + "\n";
}

}  // namespace

std::string bash_completions(const CommandHelp& root) {
  std::string script = "_pelage() {\n" + command_loop(root, "\"${COMP_WORDS[@]:1:COMP_CWORD-1}\"");
  script += "  local words=\"\" scene=\"\" name word=\"${COMP_WORDS[COMP_CWORD]}\"\n  case \"$named\" in\n";
  for (const CommandHelp* command : all_commands(root)) {
    std::string words;
    for (const auto& [word, help] : candidates_after(*command, root)) words += (words.empty() ? "" : " ") + word;
    script += fmt::format("    {}) words={}{} ;;\n", shell_quoted(command->name), shell_quoted(words),
                          begins_with_scene(*command) ? " scene=yes" : "");
  }
  script +=
      "  esac\n  case \"$named ${COMP_WORDS[COMP_CWORD-1]}\" in\n" + value_cases(root, "scene='' words='", "' ;;");
  return script + R"sh(  esac
  COMPREPLY=($(compgen -W "$words" -- "$word"))
  if [ -n "$scene" ] && [ "${word#-}" = "$word" ]; then
    while IFS= read -r name; do
      if [ "${name#"$word"}" != "$name" ] || [ -z "$word" ]; then COMPREPLY+=("$(printf %q "$name")"); fi
    done < <(pelage list --names 2>/dev/null)
  fi
}
complete -o default -F _pelage pelage
)sh";
}

std::string zsh_completions(const CommandHelp& root) {
  std::string script = "#compdef pelage\n_pelage() {\n" + command_loop(root, "\"${(@)words[2,CURRENT-1]}\"");
  script += "  local -a known names\n  local scene=\"\"\n  case \"$named\" in\n";
  for (const CommandHelp* command : all_commands(root)) {
    std::string known;
    for (const auto& [word, help] : candidates_after(*command, root)) known += " " + shell_quoted(word + ":" + help);
    script += fmt::format("    {}) known=({} ){} ;;\n", shell_quoted(command->name), known,
                          begins_with_scene(*command) ? " scene=yes" : "");
  }
  script += "  esac\n  case \"$named $words[CURRENT-1]\" in\n" + value_cases(root, "compadd ", "; return ;;");
  return script + R"sh(  esac
  if [[ -n $scene ]]; then
    names=("${(@f)$(pelage list --names 2>/dev/null)}")
    compadd -a names
  fi
  _describe pelage known || _files
}
compdef _pelage pelage
)sh";
}

std::string fish_completions(const CommandHelp& root) {
  std::string script;
  for (const CommandHelp* command : all_commands(root)) {
    std::string no_subcommand = fish_condition(*command);
    if (!command->name.empty() && !command->commands.empty()) {
      no_subcommand += "; and not __fish_seen_subcommand_from";
      for (const CommandHelp& subcommand : command->commands) no_subcommand += " " + last_word(subcommand.name);
    }
    for (const CommandHelp& subcommand : command->commands)
      script += fmt::format("complete -c pelage -n {} -f -a {} -d {}\n", fish_quoted(no_subcommand),
                            last_word(subcommand.name), fish_quoted(subcommand.words));
    const std::string condition = command->name.empty() ? "" : fish_condition(*command);
    if (begins_with_scene(*command))
      script += "complete -c pelage -n " + fish_quoted(condition) + " -a '(pelage list --names 2>/dev/null)'\n";
    for (const OptionHelp& option : command->options)
      if (command->name.empty() || option.names.back() != "--help") script += fish_option(option, condition);
  }
  return script;
}

}  // namespace pelage
