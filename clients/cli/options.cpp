#include "clients/cli/options.h"

#include <CLI/CLI.hpp>

namespace pelage {

namespace {

constexpr int usage_error = 2;

CLI::App* add_action(CLI::App& app, Options& options, Action action, const char* name, const char* help) {
  CLI::App* command = app.add_subcommand(name, help);
  command->callback([&options, action] { options.action = action; });
  command->fallthrough();
  return command;
}

void add_scene(CLI::App* command, Options& options) {
  command->add_option("scene", options.scene, "Id or name of the scene")->required();
}

void add_fur(CLI::App* command, Options& options) {
  command->add_option("--length", options.length, "Length of the first fur in sizes of the model, 0 to 10")
      ->capture_default_str();
  command->add_option("--inclination", options.inclination, "Lean of the first fur, 0 upright to 1 lying")
      ->capture_default_str();
  command->add_option("--form", options.form,
                      "even, or animal: shorter on face and paws, longer on chest and tail [animal for files, even for "
                      "built-in models]");
  command
      ->add_option("--fur-patches", options.fur_patches,
                   "How fur is laid: overlapping, hard, or own_uvs by the model's texture coordinates")
      ->capture_default_str();
}

/// Options that are handed on under the name that frame.png knows them by.
void add_frame_parameter(CLI::App* command, Options& options, const char* flag, const char* parameter,
                         const char* help) {
  command->add_option_function<std::string>(
      flag, [&options, parameter](const std::string& value) { options.frame.emplace_back(parameter, value); }, help);
}

void add_view(CLI::App* command, Options& options) {
  add_frame_parameter(command, options, "--width", "width", "Pixels, 1 to 8192 [512]");
  add_frame_parameter(command, options, "--height", "height", "Pixels, 1 to 8192 [512]");
  add_frame_parameter(command, options, "--camera", "camera", "front, back, left, right, top or three_quarter");
  add_frame_parameter(command, options, "--position", "position", "X,Y,Z of a free camera, with --target");
  add_frame_parameter(command, options, "--target", "target", "X,Y,Z that it looks at");
  add_frame_parameter(command, options, "--up", "up", "X,Y,Z that is up [0,1,0]");
  add_frame_parameter(command, options, "--fov", "fov_degrees", "Vertical field of view, degrees, 1 to 150 [35]");
}

/// NAME=VALUE, each.
void add_pairs(const std::vector<std::string>& texts, Parameters& pairs) {
  for (const std::string& text : texts) {
    const std::size_t equals = std::min(text.find('='), text.size());
    pairs.emplace_back(text.substr(0, equals), text.substr(std::min(equals + 1, text.size())));
  }
}

void add_knob(CLI::App* command, Options& options) {
  command->add_option_function<std::vector<std::string>>(
      "--knob", [&options](const std::vector<std::string>& texts) { add_pairs(texts, options.frame); },
      "NAME=VALUE of a single knob, such as shells=48; may be repeated");
}

void add_variables(CLI::App* command, Options& options) {
  command->add_option_function<std::vector<std::string>>(
      "--set", [&options](const std::vector<std::string>& texts) { add_pairs(texts, options.variables); },
      "NAME=VALUE of a recipe's variable, as JSON or plain text; may be repeated");
}

/// Changes of what has been done.
void declare_history_actions(CLI::App& app, Options& options) {
  CLI::App* amend = add_action(app, options, Action::amend, "amend",
                               "Put other commands in the place of an earlier step and replay what follows");
  add_scene(amend, options);
  amend->add_option("revision", options.count, "A revision of the step, marked * in `pelage log`")->required();
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

  CLI::App* branch = add_action(app, options, Action::branch, "branch",
                                "Make a scene of its own that begins as this one was; prints its id");
  add_scene(branch, options);
  branch->add_option("name", options.name, "Name of the new scene, 1 to 200 bytes")->required();
  branch->add_option("--revision", options.revision, "Where it begins [the present]");
}

/// Options that are handed on under the name that the address of a map knows them by.
void add_map_parameter(CLI::App* command, Options& options, const char* flag, const char* parameter, const char* help) {
  command->add_option_function<std::string>(
      flag, [&options, parameter](const std::string& value) { options.map_parameters.emplace_back(parameter, value); },
      help);
}

void add_map(CLI::App* command, Options& options, bool field_is_chosen = true) {
  add_scene(command, options);
  if (!field_is_chosen) return;
  command->add_option("field", options.field, "direction, length, density, mask or another field")->required();
  add_map_parameter(command, options, "--encoding", "encoding",
                    "Of direction uv_tangent, fast_fur or vector; else value");
  add_map_parameter(
      command, options, "--scale", "scale",
      "What 1 in the picture stands for [get: the largest value, 1 for EXR; put: what the file says, or 1]");
  add_map_parameter(command, options, "--units", "units",
                    "Of a scale of lengths: relative (sizes) or world [relative]");
}

void declare_export(CLI::App& app, Options& options) {
  CLI::App* command = add_action(app, options, Action::export_fur, "export",
                                 "Write the fur in another program's format, or the whole scene");
  add_scene(command, options);
  command->add_option("-o,--output", options.output, "The file, .usda, .hair, .glb or .pelage")->required();
  const auto add = [&](const char* flag, const char* parameter, const char* help) {
    command->add_option_function<std::string>(
        flag,
        [&options, parameter](const std::string& value) { options.export_parameters.emplace_back(parameter, value); },
        help);
  };
  add("--format", "format", "usda, hair, shells, fields or pelage [the output's ending, shells for .glb]");
  add("--shells", "shells", "Layers of shells, 1 to 32 [16]");
  add("--every", "every", "About one strand of so many, 1 to 1000000 [1]");
  command->add_flag_callback(
      "--widen", [&options] { options.export_parameters.emplace_back("widen", "true"); },
      "Make the strands that are left so much wider that they cover as much");
  command->add_flag_callback(
      "--no-curves", [&options] { options.export_parameters.emplace_back("curves", "false"); },
      "Without whiskers, lashes and brows");
  command->add_flag("--dry-run", options.dry_run, "Say how much it would be; write nothing");
}

void declare_open(CLI::App& app, Options& options) {
  CLI::App* command = add_action(app, options, Action::open_saved, "open",
                                 "Make a scene of a .pelage file, with its log; prints its id");
  command->add_option("file", options.file, "The file, as `pelage export` writes it")->required();
  command->add_option("--name", options.name, "Name, 1 to 200 bytes [the file's own]")->default_str("");
}

void declare_map_actions(CLI::App& app, Options& options) {
  CLI::App* map = app.add_subcommand("map", "Fields as pictures through a model's texture coordinates");
  map->require_subcommand(1);
  map->fallthrough();

  CLI::App* get = add_action(*map, options, Action::get_map, "get", "Write a field as a picture");
  add_map(get, options);
  get->add_option("-o,--output", options.output, "The picture, .png, .exr or .npy; - for standard output")->required();
  add_map_parameter(get, options, "--format", "format",
                    "png, png16, exr, exr_half or npy [the output's ending, png16 for .png]");
  add_map_parameter(get, options, "--size", "size", "Pixels of a side, 1 to 8192 [1024]");
  add_map_parameter(get, options, "--dilate", "dilate", "Pixels by which islands grow over their seams, 0 to 64 [8]");

  CLI::App* put = add_action(*map, options, Action::put_map, "put", "Read a field from a picture, as one undo step");
  add_map(put, options);
  put->add_option("file", options.file,
                  "PNG, JPEG, EXR or HDR, up to 4096 pixels wide, or a NumPy array; - for standard input")
      ->required();
  add_map_parameter(put, options, "--strength", "strength", "How far the field goes to the picture's, 0 to 1 [1]");

  CLI::App* keep = add_action(*map, options, Action::put_picture, "upload",
                              "Keep a picture for commands to name, such as mask; prints its name");
  add_map(keep, options, false);
  keep->add_option("file", options.file, "The picture; - for standard input")->required();
}

/// How a file is read.
void add_import(CLI::App* command, Options& options) {
  command->add_option("--format", options.format, "obj, ply, stl, off, gltf, glb, 3ds or zip [the file's ending]");
  command->add_option("--up", options.up, "Axis of the file that is up: x, -x, y, -y, z or -z [z of stl, else y]");
  command->add_option("--front", options.front,
                      "Axis of the file that the model faces [as its joints say; else -y where z is up, z where y is]");
  command->add_option("--pose", options.pose, "NAME@SECONDS of an animation of the file that it stands in");
  command->add_option("--crease-degrees", options.crease_degrees,
                      "Edges that are sharper are seen as edges, 0 to 180; 180 for none [60]");
  command->add_option("--flip", options.flip,
                      "Number of a part that turns inside out, as the load reports doubtful ones");
  command->add_option("--two-sided", options.two_sided,
                      "Number of a part of one layer that grows fur on both sides, as the load reports sheets");
}

void declare_scene_actions(CLI::App& app, Options& options) {
  CLI::App* create = add_action(app, options, Action::create, "new",
                                "Make a scene with a built-in model, or one of a file; prints its id");
  create->add_option("--name", options.name, "Name, 1 to 200 bytes")->capture_default_str();
  CLI::Option* builtin =
      create->add_option("--builtin", options.builtin, "torus, knot, sphere, plane, cloth or creature")
          ->capture_default_str();
  create->add_option("--triangles", options.triangles, "Wished-for triangles of a built-in model")
      ->capture_default_str();
  create->add_option("--file", options.file, "A model in its place, loaded as by `pelage load`")->excludes(builtin);
  add_import(create, options);
  add_fur(create, options);

  CLI::App* load = add_action(app, options, Action::load, "load",
                              "Give a scene a model from a file, with the files that it names; its log starts empty");
  add_scene(load, options);
  load->add_option("file", options.file, "The model; - for standard input")->required();
  add_import(load, options);
  add_fur(load, options);

  CLI::App* environment =
      add_action(app, options, Action::environment, "environment",
                 "Light a scene from all around with a picture: EXR or HDR, as wide as 360 degrees");
  add_scene(environment, options);
  environment->add_option("file", options.file, "The picture, up to 4096 pixels wide; - for standard input")
      ->required();
  environment->add_option("--intensity", options.intensity, "Factor on its light, 0 to 100")->capture_default_str();
  environment
      ->add_option("--turn-degrees", options.turn_degrees, "About +y, counter-clockwise seen from above, -360 to 360")
      ->capture_default_str();

  CLI::App* base = add_action(app, options, Action::skin_texture, "skin-texture",
                              "Lay a PNG or JPEG on a model by its texture coordinates");
  add_scene(base, options);
  base->add_option("file", options.file, "The picture, up to 4096 pixels wide; - for standard input")->required();

  CLI::App* subdivide = add_action(app, options, Action::subdivide, "subdivide",
                                   "Split the triangles of a scene's model in four; fields stay, its log starts empty");
  add_scene(subdivide, options);
  subdivide->add_option("--levels", options.levels, "How often, 1 to 8")->capture_default_str();
  subdivide->add_flag("--masked", options.masked, "Only triangles with a corner whose mask is above 0.5");

  add_action(app, options, Action::list, "list", "List the scenes");
  add_scene(add_action(app, options, Action::info, "info", "Describe a scene"), options);
  add_scene(add_action(app, options, Action::remove, "rm", "Remove a scene"), options);
}

void declare_groom_actions(CLI::App& app, Options& options) {
  CLI::App* run = add_action(app, options, Action::run, "run", "Run commands; each line or element is one undo step");
  add_scene(run, options);
  run->add_option("file", options.file,
                  "A recipe, JSON lines (as of `pelage log --lines`), an array or one command; - for standard input")
      ->required();
  add_variables(run, options);
  run->add_flag("--dry-run", options.dry_run, "Say what each step would touch, after those before it; change nothing");
  run->add_option("--if-match", options.if_match, "Run only when the scene is at this revision");

  for (const auto& [action, name, help] : {std::tuple{Action::undo, "undo", "Take back the newest steps"},
                                           std::tuple{Action::redo, "redo", "Do again what was taken back"}}) {
    CLI::App* command = add_action(app, options, action, name, help);
    add_scene(command, options);
    command->add_option("steps", options.count, "How many")->capture_default_str();
  }
  CLI::App* revert = add_action(app, options, Action::revert, "revert", "Go back to an earlier revision");
  add_scene(revert, options);
  revert->add_option("revision", options.count, "The revision")->required();

  CLI::App* log = add_action(app, options, Action::log, "log", "Show the undo log; * marks what leads to the present");
  add_scene(log, options);
  CLI::Option* lines =
      log->add_flag("--lines", options.lines, "The commands that lead to the present, as JSON lines for `pelage run`");
  log->add_option("--for", options.other,
                  "Id or name of another scene: places, directions and lengths are carried to its model")
      ->needs(lines);
}

/// Options that are handed on as members of Tracing.
void add_tracing(CLI::App* command, Options& options) {
  const auto add = [&](const char* flag, const char* member, const char* help) {
    command->add_option_function<std::string>(
        flag, [&options, member](const std::string& value) { options.trace.emplace_back(member, value); }, help);
  };
  add("--passes", "passes", "Of traced strands, at most: samples of a pixel, 1 to 65536 [64]");
  add("--noise", "noise", "Ends when the mean error of a shown channel is below, 0 to 1; 0 never [0]");
  add("--seconds", "seconds", "Ends after so much tracing, 0 to 3600; 0 never [0]");
  add("--transport", "transport", "transmittance, or paths that scatter from strand to strand [transmittance]");
  add("--scattering", "scattering", "look or energy_conserving; paths take energy_conserving alone [look]");
  add("--bounces", "bounces", "With --transport paths: at most, 1 to 4096 [32]");
  add("--strands", "strands", "At most, 1 to 8000000; fewer are drawn wider [2000000]");
  add("--filter", "filter", "true or false: smooths pictures of few passes [true]");
  add("--seed", "seed", "The same seed and passes give the same picture [1]");
  CLI::Option* progressive =
      command->add_flag("--progressive", options.progressive,
                        "Writes shells at once, then each better picture of traced strands over the same file");
  command->add_option("--until-pass", options.until_pass, "With --progressive: ends with a picture of so many passes")
      ->needs(progressive)
      ->check(CLI::PositiveNumber);
  command->add_option("--for", options.for_seconds, "With --progressive: ends after so many seconds")
      ->needs(progressive)
      ->check(CLI::NonNegativeNumber);
}

void declare_trade(CLI::App& app, Options& options) {
  CLI::App* trade = add_action(app, options, Action::trade, "trade",
                               "Measure what each quality costs and how far it is from the truth: a table and a page");
  trade->add_option("-o,--output", options.output, "Folder for results.csv and index.html")->required();
  trade->add_option("--scene", options.scenes,
                    "Id or name of a scene to measure as it is; may be repeated [built-in ones]");
  trade->add_flag("--quick", options.quick, "One small scene and few knobs: a look at the page in seconds");
  trade->add_flag("--resume", options.resume, "Keep what results.csv has already");
  trade->add_option("--size", options.size, "Pixels of a side")->capture_default_str()->check(CLI::Range(16, 2048));
  trade->add_option("--truth", options.truth, "Sorted shells of the truth")
      ->capture_default_str()
      ->check(CLI::Range(2, 1024));
  trade->add_option("--passes", options.r2_passes, "Of traced strands")
      ->capture_default_str()
      ->check(CLI::Range(1, 65536));
  trade->add_option("--repeats", options.repeats, "Timed frames of each setting; the least counts")
      ->capture_default_str()
      ->check(CLI::Range(1, 100));
}

void declare_picture_actions(CLI::App& app, Options& options) {
  CLI::App* frame = add_action(app, options, Action::frame, "frame", "Draw a scene");
  add_scene(frame, options);
  frame->add_option("-o,--output", options.output, "The picture; - for standard output")->capture_default_str();
  add_view(frame, options);
  add_frame_parameter(frame, options, "--quality", "quality",
                      "draft, interactive, detailed or reference [interactive]");
  add_knob(frame, options);
  add_tracing(frame, options);
  add_frame_parameter(frame, options, "--budget-ms", "budget_ms",
                      "In place of a quality: the best that is drawn in so many milliseconds, 1 to 600000");
  add_frame_parameter(frame, options, "--max-error", "max_error",
                      "In place of a quality: the cheapest with at most this mean FLIP over the fur, up to 1");
  add_frame_parameter(frame, options, "--max-seconds", "max_seconds",
                      "Refuse to draw shells that are expected to take longer, 1 to 86400 [60]");
  frame->add_flag("--dry-run", options.dry_run, "Say how long drawing is expected to take; draw nothing");
  add_frame_parameter(frame, options, "--background", "background", "transparent, studio or #rrggbb");
  add_frame_parameter(frame, options, "--exposure", "exposure", "Stops, -20 to 20 [0]");
  add_frame_parameter(frame, options, "--tone-map", "tone_map", "none or filmic [filmic]");
  add_frame_parameter(frame, options, "--colour-source", "colour_source",
                      "automatic, model or coat; default look otherwise");

  add_frame_parameter(frame, options, "--format", "format",
                      "png, png16, jpeg, exr, npy or npy_linear [the output's ending]");
  add_frame_parameter(frame, options, "--jpeg-quality", "jpeg_quality", "1 to 100 [90]");
  add_frame_parameter(frame, options, "--exr-type", "exr_type", "half or float [half]");
  add_frame_parameter(frame, options, "--aovs", "aovs",
                      "Of an EXR, with commas: beauty, alpha, depth, position, normal, tangent, albedo, direct, "
                      "shadow, shell_count [beauty]");
  add_frame_parameter(frame, options, "--overlay", "overlay",
                      "none, direction, strokes, length, density, wetness, mask, shell_count, light_depth, "
                      "light_occlusion, shadow_width or difference [none]");
  add_frame_parameter(frame, options, "--from", "overlay_from",
                      "With --overlay difference: the revision to compare with");
  add_frame_parameter(frame, options, "--revision", "revision", "Draw the scene as it was at this revision");

  CLI::App* compare =
      add_action(app, options, Action::compare, "compare", "Measure how far one picture is from another");
  compare->add_option("reference", options.reference, "The true picture: PNG, JPEG, EXR or HDR")->required();
  compare->add_option("test", options.test, "The picture to measure, of the same size")->required();
  compare->add_option("--mask", options.mask,
                      "Picture of where to measure: its alpha, or what is brighter than half [the alpha of both]");
  compare->add_option("--map", options.map, "PNG of where the error is, dark for none");
  compare->add_option("--tone-map", options.tone_map, "How EXR and HDR are shown, for FLIP: none or filmic")
      ->capture_default_str()
      ->check(CLI::IsMember({"none", "filmic"}));

  declare_trade(app, options);

  CLI::App* pick = add_action(app, options, Action::pick, "pick", "Say what lies under a pixel");
  add_scene(pick, options);
  pick->add_option("x", options.x, "Pixels from the left")->required();
  pick->add_option("y", options.y, "Pixels from the top")->required();
  add_view(pick, options);
}

void declare_calibrate(CLI::App& app, Options& options) {
  CLI::App* calibrate = add_action(app, options, Action::calibrate, "calibrate",
                                   "Measure what frames cost on this machine, for servers that start here from now on");
  const auto add = [&](const char* flag, const char* help) {
    calibrate->add_option_function<std::string>(
        flag, [&options, flag](const std::string& value) { options.server_options.emplace_back(flag, value); }, help);
  };
  add("--data", "The server's folder, where the calibration is stored [pelage-data]");
  add("--calibration", "Another file for it");
  add("--gl", "As the server's: auto, egl or osmesa [auto]");
  add("--threads", "As the server's: threads of a software GL, 0 for all cores [0]");
}

}  // namespace

ParsedLine parse_line(int argc, char** argv) {
  ParsedLine parsed;
  Options& options = parsed.options;
  CLI::App app{"Grooms fur on a Pelage server."};
  app.require_subcommand(1);
  app.add_option("--server", options.server, "Address of the server")
      ->envname("PELAGE_SERVER")
      ->default_val("http://127.0.0.1:8080");
  app.add_option("--token", options.token, "Token of the server")->envname("PELAGE_TOKEN");
  app.add_option("--author", options.author, "Your name, 1 to 200 bytes, kept with each change and shown to others");
  app.add_flag("--json", options.json, "Print the server's answer as JSON");
  app.set_version_flag("--version", "pelage " PELAGE_VERSION);
  app.footer(
      "Examples:\n"
      "  pelaged --data groom-data & pelage wait\n"
      "  pelage new --name fox --file fox.glb\n"
      "  pelage run fox clients/recipes/spot.json --dry-run\n"
      "  pelage frame fox -o fox.png --quality detailed\n"
      "  pelage export fox -o fox.usda --every 16\n"
      "Exit codes: 0 done, 1 failed, 2 wrong use, 3 the input was refused.");
  CLI::App* wait = add_action(app, options, Action::wait, "wait", "Wait until the server is ready");
  wait->add_option("--seconds", options.wait_seconds, "How long at most, 0 to 3600")
      ->capture_default_str()
      ->check(CLI::Range(0, 3600));
  declare_scene_actions(app, options);
  declare_export(app, options), declare_open(app, options);
  declare_map_actions(app, options);
  declare_groom_actions(app, options);
  declare_history_actions(app, options);
  declare_picture_actions(app, options);
  declare_calibrate(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    parsed.exit_code = app.exit(error) == 0 ? 0 : usage_error;
  }
  return parsed;
}

}  // namespace pelage
