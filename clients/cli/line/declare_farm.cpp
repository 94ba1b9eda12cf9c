#include <CLI/CLI.hpp>

#include "clients/cli/line/declare.h"

namespace pelage {

namespace {

constexpr const char* frames_help = "Folder of `pelage farm submit`, job, or frames as \"out/fox.####.png\"";

// The values are not stored: pelage-farm gets the command line unchanged. The declarations serve checks and help.

CLI::Option* add_value(CLI::App* command, const char* flag, const std::string& help) {
  return command->add_option(flag, help)->type_name("TEXT");
}

void add_flag(CLI::App* command, const char* flag, const std::string& help) { command->add_flag(flag, help); }

template <typename Number>
void add_number(CLI::App* command, const char* flag, const char* help, Number min, Number max) {
  add_value(command, flag, help)->type_name("")->check(CLI::Range(min, max));
}

void declare_farm_pack(CLI::App& farm, Options& options) {
  CLI::App* pack = add_action(farm, options, Action::farm, "pack",
                              "Write a .pelage file for a job: a scene on the server, or a model with a recipe");
  add_value(pack, "scene", "Id or name of a scene on the server; not with --file or --builtin");
  add_value(pack, "-o,--output", "The file, .pelage")->required();
  add_value(pack, "--file", "Model to groom on a private server");
  add_value(pack, "--builtin", "Built-in model to groom on a private server, as for `pelage new`");
  add_number(pack, "--triangles", "About how many triangles --builtin has, 2 to 1000000 [5000]", 2, 1000000);
  add_value(pack, "--recipe", "Recipe that grooms the model");
  add_value(pack, "--set", "NAME=VALUE of a recipe's variable; may be repeated")->expected(-1);
}

void declare_farm_submit(CLI::App& farm, Options& options) {
  CLI::App* submit = add_action(farm, options, Action::farm, "submit",
                                "Time a few frames, split the job into chunks and submit them; again: missing ones");
  add_value(submit, "job", "The job's JSON file, or the folder made from it")->required();
  add_value(submit, "--engine", "slurm, local (this machine), openjd or kubernetes [slurm]")
      ->check(CLI::IsMember({"slurm", "local", "openjd", "kubernetes"}));
  add_value(submit, "--folder", "Folder for job, scene, chunks, logs and frames [fox.farm beside fox.json]");
  add_number(submit, "--chunk-seconds", "Seconds that a chunk should take, 1 to 86400 [120]", 1.0, 86400.0);
  add_number(submit, "--max-parallel", "Maximum chunks at once, 0 to 1000, not for openjd [0: all; local: 2]", 0, 1000);
  add_number(submit, "--threads", "Cores for each chunk, 0 to 1024 [0: what the engine gives]", 0, 1024);
  add_value(submit, "--image", "Container image of kubernetes [pelage]");
  add_value(submit, "--claim", "PersistentVolumeClaim of kubernetes that holds the folder [farm]");
  add_flag(submit, "--dry-run", "Write the folder and the engine's files; submit nothing");
}

void declare_farm_status(CLI::App& farm, Options& options) {
  CLI::App* status = add_action(farm, options, Action::farm, "status",
                                "Show a job's progress: frames done and failed, running tasks, seconds left");
  add_value(status, "folder", "Folder of `pelage farm submit`, or its job")->required();
  add_flag(status, "--watch", "Follow it until no task waits or runs");
}

void declare_farm_check(CLI::App& farm, Options& options) {
  CLI::App* check = add_action(farm, options, Action::farm, "check",
                               "Find frames that are missing, cut short, black, of a wrong size or of another scene");
  add_value(check, "job", "Folder of `pelage farm submit`, or a job")->required();
  add_number(check, "--black", "A frame is black if no pixel is brighter than this, 0 to 1 [0.02]", 0.0, 1.0);
}

void declare_farm_movie(CLI::App& farm, Options& options) {
  CLI::App* movie = add_action(farm, options, Action::farm, "movie", "Make a clip of frames, with ffmpeg");
  add_value(movie, "frames", frames_help)->required();
  add_value(movie, "-o,--output", "The clip, .mp4, .webp or .gif")->required();
  add_number(movie, "--fps", "Frames per second, 0 to 1000 [0: the job's, or 24]", 0.0, 1000.0);
  add_number(movie, "--width", "Width in pixels, 0 to 8192 [0: the frames']", 0, 8192);
}

void declare_farm_sheet(CLI::App& farm, Options& options) {
  CLI::App* sheet = add_action(farm, options, Action::farm, "sheet", "Make a contact sheet of frames, with ffmpeg");
  add_value(sheet, "frames", frames_help)->required();
  add_value(sheet, "-o,--output", "The sheet, .png or .jpg")->required();
  add_number(sheet, "--count", "Pictures, evenly spaced, 0 to 1000; 0: all [24]", 0, 1000);
  add_number(sheet, "--columns", "Pictures in a row, 1 to 100 [6]", 1, 100);
  add_number(sheet, "--width", "Width of each picture, pixels, 1 to 4096 [240]", 1, 4096);
}

}  // namespace

void declare_farm_actions(CLI::App& app, Options& options) {
  CLI::App* farm = app.add_subcommand("farm", "Draw a job's frames on many machines, and check them");
  farm->require_subcommand(1);
  farm->fallthrough();
  declare_farm_pack(*farm, options);
  declare_farm_submit(*farm, options);
  declare_farm_status(*farm, options);
  declare_farm_check(*farm, options);
  declare_farm_movie(*farm, options);
  declare_farm_sheet(*farm, options);
}

}  // namespace pelage
