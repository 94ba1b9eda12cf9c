#include <CLI/CLI.hpp>

#include "clients/cli/line/declare.h"

namespace pelage {

namespace {

void declare_run(CLI::App& app, Options& options) {
  CLI::App* run =
      add_action(app, options, Action::run, "run", "Run a file of commands; each line or step is one undo step");
  add_scene(run, options);
  run->add_option("file", options.file,
                  "A recipe, an array, one command, or JSON lines of `pelage log --lines`; - for standard input")
      ->required();
  add_variables(run, options);
  CLI::Option* dry_run =
      run->add_flag("--dry-run", options.dry_run, "Try all steps in order and print what each touches; change nothing");
  run->add_flag("--verbose", options.verbose, "Print what each command did, not only a summary");
  run->add_flag("--watch", options.watch,
                "Undo the run and run again when the file or an included one changes; Ctrl-C ends it")
      ->excludes(dry_run);
  run->add_option("--if-match", options.if_match, "Run only if the scene is at this revision");
}

void declare_amend(CLI::App& app, Options& options) {
  CLI::App* amend = add_action(app, options, Action::amend, "amend",
                               "Replace the commands of an earlier step and replay the steps after it");
  add_scene(amend, options);
  amend->add_option("step", options.count, "Number of the step, or a revision of it that `pelage log` marks *")
      ->required();
  CLI::Option* file =
      amend->add_option("file", options.file, "The new commands, as for `pelage run`; - for standard input");
  CLI::Option* drop = amend->add_flag("--drop", options.drop, "Remove the step; takes no file")->excludes(file);
  amend->callback([&options, file, drop] {
    options.action = Action::amend;
    if (file->count() + drop->count() == 0) throw CLI::ValidationError("amend", "a file or --drop is required");
  });
  add_variables(amend, options);
  amend->add_flag("--dry-run", options.dry_run, "Print what each command would touch; change nothing");
  amend->add_option("--if-match", options.if_match, "Amend only if the scene is at this revision");
}

void declare_log(CLI::App& app, Options& options) {
  CLI::App* log =
      add_action(app, options, Action::log, "log",
                 "Show the undo log: revision, commands, vertices touched, step; * marks what is in effect");
  add_scene(log, options);
  CLI::Option* lines =
      log->add_flag("--lines", options.lines, "Print the commands in effect, as JSON lines for `pelage run`");
  log->add_option("--for", options.other,
                  "Id or name of another scene: adapt positions, directions and lengths to its model")
      ->needs(lines);
}

}  // namespace

void declare_groom_actions(CLI::App& app, Options& options) { declare_run(app, options); }

void declare_history_actions(CLI::App& app, Options& options) {
  for (const auto& [action, name, help] : {std::tuple{Action::undo, "undo", "Undo the newest steps"},
                                           std::tuple{Action::redo, "redo", "Redo what was undone"}}) {
    CLI::App* command = add_action(app, options, action, name, help);
    add_scene(command, options);
    command->add_option("steps", options.count, "How many steps")->capture_default_str();
  }
  CLI::App* revert = add_action(app, options, Action::revert, "revert", "Go back to an earlier revision");
  add_scene(revert, options);
  revert->add_option("revision", options.count, "The revision")->required();

  declare_amend(app, options);
  CLI::App* branch =
      add_action(app, options, Action::branch, "branch", "Make a new scene from a revision of this one; prints its id");
  add_scene(branch, options);
  branch->add_option("name", options.name, "Name of the new scene, 1 to 200 bytes")->required();
  branch->add_option("--revision", options.revision, "Revision it begins as [the current one]");
  declare_log(app, options);
}

}  // namespace pelage
