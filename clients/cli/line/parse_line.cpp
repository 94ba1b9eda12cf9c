#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstring>

#include "base/version/version.h"
#include "clients/cli/help/completions.h"
#include "clients/cli/help/examples.h"
#include "clients/cli/help/man.h"
#include "clients/cli/line/declare.h"
#include "clients/cli/line/flags.h"
#include "clients/cli/terminal/report.h"
#include "protocol/json/reader.h"

namespace pelage {

namespace {

/// Returns an error with the nearest known name if an unknown word stands in place of a command; else ok.
Status unknown_command(const CLI::App& app) {
  const CLI::App* last = &app;
  while (!last->get_subcommands().empty()) last = last->get_subcommands().front();
  const std::vector<std::string> words = app.remaining(true);
  if (words.empty() || words.front().starts_with("-") || last->get_require_subcommand_min() == 0) return {};
  std::vector<std::string_view> known;
  for (const CLI::App* command : last->get_subcommands([](const CLI::App*) { return true; }))
    known.push_back(command->get_name());
  return failure(Code::invalid, "There is no command \"" + words.front() + "\".", "", "",
                 nearest_name(words.front(), known));
}

/// Prints why CLI11 rejected the command line, or the help text that was asked for. Returns the exit code.
int report_parse_error(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const bool json = std::any_of(argv, argv + argc, [](const char* word) { return std::strcmp(word, "--json") == 0; });
  if (Status unknown = unknown_command(app); error.get_exit_code() != 0 && !unknown.ok()) {
    set_report_style({.json = json, .flags = {}});
    report(with_next(std::move(unknown), "see `pelage --help`"));
    return wrong_use;
  }
  if (error.get_exit_code() == 0 || !json) return app.exit(error) == 0 ? done : wrong_use;
  set_report_style({.json = true, .flags = {}});
  report(with_next(failure(Code::invalid, error.what()), "see `pelage --help`"));
  return wrong_use;
}

/// Prints the manual page or a completion script, which need no server. Returns false if neither was asked for.
bool print_man_or_completions(const CLI::App& app, const Options& options) {
  const CommandHelp root = tree_of(app);
  std::string text;
  if (options.action == Action::man) text = man_page(root, std::string("pelage ") + version());
  if (options.action == Action::completions)
    text = options.shell == "bash"  ? bash_completions(root)
           : options.shell == "zsh" ? zsh_completions(root)
                                    : fish_completions(root);
  std::fputs(text.c_str(), stdout);
  return !text.empty();
}

}  // namespace

void declare_line(CLI::App& app, Options& options) {
  app.require_subcommand(1);
  app.add_option("--server", options.server, "Address of the server")
      ->envname("PELAGE_SERVER")
      ->default_val("http://127.0.0.1:8080");
  app.add_option("--token", options.token, "Token of the server")->envname("PELAGE_TOKEN");
  app.add_option("--author", options.author, "Your name, 1 to 200 bytes, kept with each change and shown to others");
  app.add_flag("--json", options.json, "Print the server's answer as JSON, and errors as problem documents");
  app.set_version_flag("--version", version_line("pelage"));
  app.footer(footer_of(""));
  declare_scene_actions(app, options);
  declare_model_actions(app, options);
  declare_groom_actions(app, options);
  declare_history_actions(app, options);
  declare_picture_actions(app, options);
  declare_file_actions(app, options);
  declare_program_actions(app, options);
  declare_farm_actions(app, options);
}

ParsedLine parse_line(int argc, char** argv) {
  ParsedLine parsed;
  Options& options = parsed.options;
  CLI::App app{"Grooms fur on a Pelage server."};
  declare_line(app, options);
  try {
    app.parse(argc, argv);
    set_report_style({options.json, flags_of(app)});
    if (print_man_or_completions(app, options)) parsed.exit_code = done;
  } catch (const CLI::ParseError& error) {
    parsed.exit_code = report_parse_error(app, error, argc, argv);
  }
  return parsed;
}

}  // namespace pelage
