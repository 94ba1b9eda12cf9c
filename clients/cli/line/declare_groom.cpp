#include <CLI/CLI.hpp>

#include "clients/cli/line/declare.h"

namespace pelage {

namespace {

void declare_run(CLI::App& app, Options& options) {
  CLI::App* run = add_action(app, options, Action::run, "run", "Run commands; each line or element is one undo step");
  add_scene(run, options);
  run->add_option("file", options.file,
                  "A recipe, JSON lines (as of `pelage log --lines`), an array or one command; - for standard input")
      ->required();
  add_variables(run, options);
  CLI::Option* dry_run = run->add_flag("--dry-run", options.dry_run,
                                       "Say what each step would touch, after those before it; change nothing");
  run->add_flag("--verbose", options.verbose, "Say what each command did, not only what all did");
  run->add_flag("--watch", options.watch,
                "Run again when the file or one that it includes changes, in place of the run before; Ctrl-C ends it")
      ->excludes(dry_run);
  run->add_option("--if-match", options.if_match, "Run only when the scene is at this revision");
}

void declare_amend(CLI::App& app, Options& options) {
  CLI::App* amend = add_action(app, options, Action::amend, "amend",
                               "Put other commands in the place of an earlier step and replay what follows");
  add_scene(amend, options);
  amend->add_option("step", options.count, "The step's number, or a revision of it, marked * in `pelage log`")
      ->required();
  CLI::Option* file =
      amend->add_option("file", options.file, "The new commands, as for `pelage run`; - for standard input");
  CLI::Option* drop = amend->add_flag("--drop", options.drop, "Leave the step out, in place of a file")->excludes(file);
  amend->callback([&options, file, drop] {
    options.action = Action::amend;
    if (file->count() + drop->count() == 0) throw CLI::ValidationError("amend", "a file or --drop is required");
  });
  add_variables(amend, options);
  amend->add_flag("--dry-run", options.dry_run, "Say what each command would touch; change nothing");
  amend->add_option("--if-match", options.if_match, "Amend only when the scene is at this revision");
}

void declare_log(CLI::App& app, Options& options) {
  CLI::App* log =
      add_action(app, options, Action::log, "log",
                 "Show the undo log: revision, number of the step, what it did; * marks what leads to the present");
  add_scene(log, options);
  CLI::Option* lines =
      log->add_flag("--lines", options.lines, "The commands that lead to the present, as JSON lines for `pelage run`");
  log->add_option("--for", options.other,
                  "Id or name of another scene: places, directions and lengths are carried to its model")
      ->needs(lines);
}

}  // namespace

void declare_groom_actions(CLI::App& app, Options& options) { declare_run(app, options); }

void declare_history_actions(CLI::App& app, Options& options) {
  for (const auto& [action, name, help] : {std::tuple{Action::undo, "undo", "Take back the newest steps"},
                                           std::tuple{Action::redo, "redo", "Do again what was taken back"}}) {
    CLI::App* command = add_action(app, options, action, name, help);
    add_scene(command, options);
    command->add_option("steps", options.count, "How many")->capture_default_str();
  }
  CLI::App* revert = add_action(app, options, Action::revert, "revert", "Go back to an earlier revision");
  add_scene(revert, options);
  revert->add_option("revision", options.count, "The revision")->required();

  declare_amend(app, options);
  CLI::App* branch = add_action(app, options, Action::branch, "branch",
                                "Make a scene of its own that begins as this one was; prints its id");
  add_scene(branch, options);
  branch->add_option("name", options.name, "Name of the new scene, 1 to 200 bytes")->required();
  branch->add_option("--revision", options.revision, "Where it begins [the present]");
  declare_log(app, options);
}

}  // namespace pelage
