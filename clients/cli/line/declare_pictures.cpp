#include <CLI/CLI.hpp>

#include "clients/cli/line/declare.h"

namespace pelage {

namespace {

void add_view(CLI::App* command, Options& options) {
  Parameters& frame = options.frame;
  add_parameter_option(command, frame, "--width", "width", "Width in pixels, 1 to 8192 [512]");
  add_parameter_option(command, frame, "--height", "height", "Height in pixels, 1 to 8192 [512]");
  add_parameter_option(command, frame, "--camera", "camera",
                       "front, back, left, right, top or three_quarter [three_quarter]");
  add_parameter_option(command, frame, "--position", "position", "X,Y,Z of a free camera, with --target");
  add_parameter_option(command, frame, "--target", "target", "X,Y,Z that it looks at");
  add_parameter_option(command, frame, "--up", "up", "X,Y,Z of its up direction [0,1,0]");
  add_parameter_option(command, frame, "--fov", "fov_degrees", "Vertical field of view, degrees, 1 to 150 [35]");
}

void add_quality(CLI::App* command, Options& options) {
  add_parameter_option(command, options.frame, "--quality", "quality",
                       "draft, interactive, detailed or reference [interactive]");
  command->add_option_function<std::vector<std::string>>(
      "--knob", [&options](const std::vector<std::string>& texts) { add_pairs(texts, options.frame); },
      "NAME=VALUE of a single knob, such as strands=4; may be repeated");
  add_parameter_option(command, options.frame, "--budget-ms", "budget_ms",
                       "Instead of --quality: the best within so many milliseconds, 1 to 600000");
  add_parameter_option(command, options.frame, "--max-error", "max_error",
                       "Instead of --quality: the cheapest with mean FLIP over the fur up to this, at most 1");
  add_parameter_option(command, options.frame, "--max-seconds", "max_seconds",
                       "Refuse a frame expected to take longer, 1 to 86400 [60]");
  command->add_flag("--dry-run", options.dry_run, "Print the expected drawing time; draw nothing");
}

/// Adds the options that set the members of Tracing.
void add_tracing(CLI::App* command, Options& options) {
  Parameters& trace = options.trace;
  add_parameter_option(command, trace, "--passes", "passes", "Maximum passes, samples per pixel, 1 to 65536 [64]");
  add_parameter_option(command, trace, "--noise", "noise",
                       "Stop at this estimated mean error of a shown channel, 0 to 1; 0: never [0]");
  add_parameter_option(command, trace, "--seconds", "seconds",
                       "Stop after so many seconds of tracing, 0 to 3600; 0: never [0]");
  add_parameter_option(command, trace, "--transport", "transport",
                       "transmittance, or paths: scattering between strands [transmittance]");
  add_parameter_option(command, trace, "--scattering", "scattering",
                       "look or energy_conserving [look; paths: energy_conserving alone]");
  add_parameter_option(command, trace, "--bounces", "bounces",
                       "Maximum bounces of a path, with --transport paths, 1 to 4096 [32]");
  add_parameter_option(command, trace, "--strands", "strands",
                       "Maximum strands, 1 to 8000000; fewer are drawn wider [2000000]");
  add_parameter_option(command, trace, "--shutter", "shutter",
                       "Motion blur of fur in the wind: shutter seconds, 0 to 10 [0]");
  add_parameter_option(command, trace, "--filter", "filter", "true or false: smooths pictures of few passes [true]");
  add_parameter_option(command, trace, "--seed", "seed", "The same seed and passes give the same picture [1]");
}

void add_progressive(CLI::App* command, Options& options) {
  CLI::Option* progressive =
      command->add_flag("--progressive", options.progressive,
                        "Write a rasterized picture at once, then overwrite it with better and better traced ones");
  command->add_option("--until-pass", options.until_pass, "With --progressive: stop at a picture of so many passes")
      ->needs(progressive)
      ->check(CLI::PositiveNumber);
  command->add_option("--for", options.for_seconds, "With --progressive: stop after so many seconds")
      ->needs(progressive)
      ->check(CLI::NonNegativeNumber);
}

void add_picture_options(CLI::App* command, Options& options) {
  Parameters& frame = options.frame;
  add_parameter_option(command, frame, "--crop", "crop",
                       "LEFT,TOP,WIDTH,HEIGHT, pixels: draw only this part of a frame");
  add_parameter_option(command, frame, "--background", "background", "transparent, studio or #rrggbb");
  add_parameter_option(command, frame, "--exposure", "exposure", "Exposure in stops, -20 to 20 [0]");
  add_parameter_option(command, frame, "--tone-map", "tone_map", "none or filmic [filmic]");
  add_parameter_option(command, frame, "--colour-source", "colour_source",
                       "automatic, model or coat, in an otherwise default look");
  add_parameter_option(command, frame, "--format", "format",
                       "png, png16, jpeg, webp, exr, npy or npy_linear [the output's ending]");
  add_parameter_option(command, frame, "--lossy-quality", "lossy_quality",
                       "Quality of JPEG and WebP, 1 to 100 [by --quality]");
  add_parameter_option(command, frame, "--exr-type", "exr_type", "half or float [half]");
  add_parameter_option(
      command, frame, "--aovs", "aovs",
      "Of EXR or npy_linear, with commas: beauty, alpha, depth, position, normal, tangent, albedo, direct, "
      "shadow, sample_count, strand, root, cryptomatte [beauty]");
  add_parameter_option(
      command, frame, "--colour-space", "colour_space",
      "Of EXR or npy_linear: a space of the server's OpenColorIO config, such as ACEScg [linear Rec. 709]");
  add_parameter_option(command, frame, "--overlay", "overlay",
                       "none, direction, strokes, length, density, wetness, mask, bald, wire or difference [none]");
  add_parameter_option(command, frame, "--overlay-coat", "overlay_coat",
                       "Coat whose field an overlay shows [the first shown]");
  add_parameter_option(command, frame, "--from", "overlay_from",
                       "With --overlay difference: the revision to compare with");
  add_parameter_option(command, frame, "--masked", "masked", "true draws only what the mask lets tools change [false]");
  add_parameter_option(command, frame, "--time", "time",
                       "Time in seconds that fur in the wind is shown at [the scene's time]");
  add_parameter_option(command, frame, "--revision", "revision", "Draw the scene as it was at this revision");
}

/// Adds the options that name a position by other means than a pixel. They and the pixel exclude each other.
void add_position_options(CLI::App* pick, Options& options) {
  std::vector<CLI::Option*> position_options = {
      pick->get_option("x"),
      pick->add_option("--ray", options.ray, "X,Y,Z,DX,DY,DZ: what a ray from X,Y,Z along DX,DY,DZ hits first"),
      pick->add_option("--farthest", options.farthest,
                       "DX,DY,DZ: the position farthest in this direction, as an ear's tip"),
      pick->add_option("--nearest", options.nearest, "X,Y,Z: the position on the surface nearest to this point")};
  for (CLI::Option* option : position_options)
    for (CLI::Option* other : position_options)
      if (option != other) option->excludes(other);
  pick->add_option("--box", options.box, "X,Y,Z,X,Y,Z: box that --farthest searches, lowest corner first")
      ->needs(position_options[2]);
  pick->add_flag("--world", options.world,
                 "X,Y,Z are the model's own coordinates, not shares of its box as in recipes");
}

void declare_pick(CLI::App& app, Options& options) {
  CLI::App* pick = add_action(app, options, Action::pick, "pick",
                              "Show what lies at a position: under a pixel, or by --ray, --farthest or --nearest");
  add_scene(pick, options);
  CLI::Option* x = pick->add_option("x", options.x, "Pixels from the left");
  CLI::Option* y = pick->add_option("y", options.y, "Pixels from the top");
  x->needs(y);
  add_view(pick, options);
  add_position_options(pick, options);
  CLI::Option* name = pick->add_option("--as", options.place_name, "Name of the place, for --places");
  pick->add_option("--places", options.places, "JSON file of named places to add it to, for `pelage run`")->needs(name);
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
