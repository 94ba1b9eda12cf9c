#include <CLI/CLI.hpp>

#include "clients/cli/line/declare.h"

namespace pelage {

namespace {

void add_view(CLI::App* command, Options& options) {
  Parameters& frame = options.frame;
  add_parameter_option(command, frame, "--width", "width", "Pixels, 1 to 8192 [512]");
  add_parameter_option(command, frame, "--height", "height", "Pixels, 1 to 8192 [512]");
  add_parameter_option(command, frame, "--camera", "camera", "front, back, left, right, top or three_quarter");
  add_parameter_option(command, frame, "--position", "position", "X,Y,Z of a free camera, with --target");
  add_parameter_option(command, frame, "--target", "target", "X,Y,Z that it looks at");
  add_parameter_option(command, frame, "--up", "up", "X,Y,Z that is up [0,1,0]");
  add_parameter_option(command, frame, "--fov", "fov_degrees", "Vertical field of view, degrees, 1 to 150 [35]");
}

void add_quality(CLI::App* command, Options& options) {
  add_parameter_option(command, options.frame, "--quality", "quality",
                       "draft, interactive, detailed or reference [interactive]");
  command->add_option_function<std::vector<std::string>>(
      "--knob", [&options](const std::vector<std::string>& texts) { add_pairs(texts, options.frame); },
      "NAME=VALUE of a single knob, such as strands=4; may be repeated");
  add_parameter_option(command, options.frame, "--budget-ms", "budget_ms",
                       "In place of a quality: the best that is drawn in so many milliseconds, 1 to 600000");
  add_parameter_option(command, options.frame, "--max-error", "max_error",
                       "In place of a quality: the cheapest with at most this mean FLIP over the fur, up to 1");
  add_parameter_option(command, options.frame, "--max-seconds", "max_seconds",
                       "Refuse to draw what is expected to take longer, 1 to 86400 [60]");
  command->add_flag("--dry-run", options.dry_run, "Say how long drawing is expected to take; draw nothing");
}

/// Adds the options that set the members of Tracing.
void add_tracing(CLI::App* command, Options& options) {
  Parameters& trace = options.trace;
  add_parameter_option(command, trace, "--passes", "passes",
                       "Passes of tracing at most: samples of a pixel, 1 to 65536 [64]");
  add_parameter_option(command, trace, "--noise", "noise",
                       "Mean error of a displayed channel at which tracing ends, 0 to 1; 0: never [0]");
  add_parameter_option(command, trace, "--seconds", "seconds",
                       "Seconds of tracing after which it ends, 0 to 3600; 0: never [0]");
  add_parameter_option(command, trace, "--transport", "transport",
                       "transmittance, or paths that scatter from strand to strand [transmittance]");
  add_parameter_option(command, trace, "--scattering", "scattering",
                       "look or energy_conserving; paths take energy_conserving alone [look]");
  add_parameter_option(command, trace, "--bounces", "bounces",
                       "Bounces of a path at most, with --transport paths, 1 to 4096 [32]");
  add_parameter_option(command, trace, "--strands", "strands",
                       "Strands at most, 1 to 8000000; fewer are drawn wider [2000000]");
  add_parameter_option(command, trace, "--shutter", "shutter", "Motion blur of fur in the wind: seconds, 0 to 10 [0]");
  add_parameter_option(command, trace, "--filter", "filter", "true or false: smooths pictures of few passes [true]");
  add_parameter_option(command, trace, "--seed", "seed", "The same seed and passes give the same picture [1]");
}

void add_progressive(CLI::App* command, Options& options) {
  CLI::Option* progressive = command->add_flag(
      "--progressive", options.progressive,
      "Writes a rasterized picture at once, then each better one of traced strands over the same file");
  command->add_option("--until-pass", options.until_pass, "With --progressive: ends with a picture of so many passes")
      ->needs(progressive)
      ->check(CLI::PositiveNumber);
  command->add_option("--for", options.for_seconds, "With --progressive: ends after so many seconds")
      ->needs(progressive)
      ->check(CLI::NonNegativeNumber);
}

void add_picture_options(CLI::App* command, Options& options) {
  Parameters& frame = options.frame;
  add_parameter_option(command, frame, "--crop", "crop",
                       "LEFT,TOP,WIDTH,HEIGHT: pixels of the frame that are drawn alone");
  add_parameter_option(command, frame, "--background", "background", "transparent, studio or #rrggbb");
  add_parameter_option(command, frame, "--exposure", "exposure", "Stops, -20 to 20 [0]");
  add_parameter_option(command, frame, "--tone-map", "tone_map", "none or filmic [filmic]");
  add_parameter_option(command, frame, "--colour-source", "colour_source",
                       "automatic, model or coat; default look otherwise");
  add_parameter_option(command, frame, "--format", "format",
                       "png, png16, jpeg, webp, exr, npy or npy_linear [the output's ending]");
  add_parameter_option(command, frame, "--lossy-quality", "lossy_quality",
                       "Quality of JPEG and WebP, 1 to 100 [by --quality]");
  add_parameter_option(command, frame, "--exr-type", "exr_type", "half or float [half]");
  add_parameter_option(command, frame, "--aovs", "aovs",
                       "Of an EXR, with commas: beauty, alpha, depth, position, normal, tangent, albedo, direct, "
                       "shadow, sample_count, strand, root, cryptomatte [beauty]");
  add_parameter_option(
      command, frame, "--colour-space", "colour_space",
      "Of an EXR: a space of the server's OpenColorIO configuration, such as ACEScg [linear Rec. 709]");
  add_parameter_option(command, frame, "--overlay", "overlay",
                       "none, direction, strokes, length, density, wetness, mask, bald, wire or difference [none]");
  add_parameter_option(command, frame, "--overlay-coat", "overlay_coat",
                       "Name of the coat whose field an overlay shows");
  add_parameter_option(command, frame, "--from", "overlay_from",
                       "With --overlay difference: the revision to compare with");
  add_parameter_option(command, frame, "--masked", "masked", "true draws only what the mask leaves to tools [false]");
  add_parameter_option(command, frame, "--time", "time",
                       "Seconds: the fur as the scene's wind has moved it by then [the scene's time]");
  add_parameter_option(command, frame, "--revision", "revision", "Draw the scene as it was at this revision");
}

/// Adds the options that name a position by other means than a pixel. They and the pixel exclude each other.
void add_position_options(CLI::App* pick, Options& options) {
  std::vector<CLI::Option*> position_options = {
      pick->get_option("x"),
      pick->add_option("--ray", options.ray, "X,Y,Z,DX,DY,DZ: what a ray from X,Y,Z along DX,DY,DZ hits first"),
      pick->add_option("--farthest", options.farthest, "DX,DY,DZ: the place that is farthest along it, as of an ear"),
      pick->add_option("--nearest", options.nearest, "X,Y,Z: the place of the surface that is nearest to it")};
  for (CLI::Option* option : position_options)
    for (CLI::Option* other : position_options)
      if (option != other) option->excludes(other);
  pick->add_option("--box", options.box, "X,Y,Z,X,Y,Z: lowest and highest corner of where --farthest looks")
      ->needs(position_options[2]);
  pick->add_flag("--world", options.world,
                 "X,Y,Z are the model's own coordinates, not shares of its box as in recipes");
}

void declare_pick(CLI::App& app, Options& options) {
  CLI::App* pick = add_action(app, options, Action::pick, "pick",
                              "Say what lies at a place: under a pixel, or by --ray, --farthest or --nearest");
  add_scene(pick, options);
  CLI::Option* x = pick->add_option("x", options.x, "Pixels from the left");
  CLI::Option* y = pick->add_option("y", options.y, "Pixels from the top");
  x->needs(y);
  add_view(pick, options);
  add_position_options(pick, options);
  CLI::Option* name = pick->add_option("--as", options.place_name, "Name of the place, for --places");
  pick->add_option("--places", options.places, "JSON file of places by name that gets this one, for `pelage run`")
      ->needs(name);
  pick->callback([&options] {
    options.action = Action::pick;
    if (options.ray.empty() && options.farthest.empty() && options.nearest.empty() && !options.x)
      throw CLI::ValidationError("pick", "a pixel, --ray, --farthest or --nearest is required");
  });
}

}  // namespace

void declare_picture_actions(CLI::App& app, Options& options) {
  CLI::App* frame = add_action(app, options, Action::frame, "frame", "Draw a scene");
  add_scene(frame, options);
  frame->add_option("-o,--output", options.output, "The picture; - for standard output")->capture_default_str();
  add_view(frame, options);
  add_quality(frame, options);
  add_tracing(frame, options);
  add_progressive(frame, options);
  add_picture_options(frame, options);
  declare_pick(app, options);
}

}  // namespace pelage
