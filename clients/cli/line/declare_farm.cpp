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
                              "Write a scene as .pelage, for a job: one of the server, or a model with a recipe");
  add_value(pack, "scene", "Id or name of a scene of the server; none with --file or --builtin");
  add_value(pack, "-o,--output", "The file, .pelage")->required();
  add_value(pack, "--file", "Model to groom on a private server");
  add_value(pack, "--builtin", "Built-in model to groom on a private server: creature, sphere, torus or plane");
  add_number(pack, "--triangles", "Triangles of a built-in model, about, 2 to 1000000 [5000]", 2, 1000000);
  add_value(pack, "--recipe", "Recipe that grooms the model");
  add_value(pack, "--set", "NAME=VALUE of a recipe's variable; may be repeated")->expected(-1);
}

void declare_farm_submit(CLI::App& farm, Options& options) {
  CLI::App* submit = add_action(farm, options, Action::farm, "submit",
                                "Measure a job, cut it into chunks and hand it to a farm; again: send what is missing");
  add_value(submit, "job", "The job, JSON, or the folder that was made of it")->required();
  add_value(submit, "--engine", "slurm, local (this machine), openjd or kubernetes [slurm]")
      ->check(CLI::IsMember({"slurm", "local", "openjd", "kubernetes"}));
  add_value(submit, "--folder", "Where job, scene, chunks, logs and frames are [fox.farm beside fox.json]");
  add_number(submit, "--chunk-seconds", "What a chunk should take, 1 to 86400 [120]", 1.0, 86400.0);
  add_number(submit, "--max-parallel", "Chunks at the same time, 0 to 1000 [0: all of them; local: 2]", 0, 1000);
  add_number(submit, "--threads", "Cores of a chunk, 0 to 1024 [0: what the engine gives]", 0, 1024);
  add_value(submit, "--image", "Container image of kubernetes [pelage]");
  add_value(submit, "--claim", "PersistentVolumeClaim of kubernetes that holds the folder [farm]");
  add_flag(submit, "--dry-run", "Write the folder and what the engine takes; submit nothing");
}

void declare_farm_status(CLI::App& farm, Options& options) {
  CLI::App* status = add_action(farm, options, Action::farm, "status",
                                "Say how far a job is: frames done and failed, tasks that run, seconds left");
  add_value(status, "folder", "Folder of `pelage farm submit`, or its job")->required();
  add_flag(status, "--watch", "Follow it until no task waits or runs");
}

void declare_farm_check(CLI::App& farm, Options& options) {
  CLI::App* check =
      add_action(farm, options, Action::farm, "check",
                 "Find missing, short and black frames, those of another size, and those of another scene");
  add_value(check, "job", "Folder of `pelage farm submit`, or a job")->required();
  add_number(check, "--black", "Brightness that some pixel of a frame must exceed, 0 to 1 [0.02]", 0.0, 1.0);
}

void declare_farm_movie(CLI::App& farm, Options& options) {
  CLI::App* movie = add_action(farm, options, Action::farm, "movie", "Make a clip of frames, with ffmpeg");
  add_value(movie, "frames", frames_help)->required();
  add_value(movie, "-o,--output", "The clip, .mp4, .webp or .gif")->required();
  add_number(movie, "--fps", "Frames a second, 0 to 1000 [the job's, or 24]", 0.0, 1000.0);
  add_number(movie, "--width", "Pixels, 0 to 8192 [0: as the frames are]", 0, 8192);
}

void declare_farm_sheet(CLI::App& farm, Options& options) {
  CLI::App* sheet = add_action(farm, options, Action::farm, "sheet", "Make a contact sheet of frames, with ffmpeg");
  add_value(sheet, "frames", frames_help)->required();
  add_value(sheet, "-o,--output", "The sheet, .png or .jpg")->required();
  add_number(sheet, "--count", "Pictures, evenly from all, 0 to 1000 [24; 0: all]", 0, 1000);
  add_number(sheet, "--columns", "Pictures in a row, 1 to 100 [6]", 1, 100);
  add_number(sheet, "--width", "Pixels of a picture, 1 to 4096 [240]", 1, 4096);
}

}  // namespace

void declare_farm_actions(CLI::App& app, Options& options) {
  CLI::App* farm = app.add_subcommand("farm", "Draw the frames of a job on many machines, and look after them");
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
