#include <CLI/CLI.hpp>

#include "clients/cli/line/declare.h"

namespace pelage {

namespace {

void declare_export(CLI::App& app, Options& options) {
  CLI::App* command = add_action(app, options, Action::export_fur, "export",
                                 "Write the fur in another program's format, or the whole scene");
  add_scene(command, options);
  command->add_option("-o,--output", options.output, "The file, .usda, .hair, .glb or .pelage")->required();
  Parameters& parameters = options.export_parameters;
  add_parameter_option(command, parameters, "--format", "format",
                       "usda, hair, shells, cards, fields or pelage [the output's ending, shells for .glb]");
  add_parameter_option(command, parameters, "--coat", "coat", "Name of the one coat to export [all not muted]");
  add_parameter_option(command, parameters, "--shells", "shells", "Number of shells, 1 to 32 [16]");
  add_parameter_option(command, parameters, "--cards", "cards",
                       "About how many cards at the finest level, 100 to 200000 [6000]");
  add_parameter_option(command, parameters, "--every", "every", "About one strand in so many, 1 to 1000000 [1]");
  command->add_flag_callback(
      "--widen", [&parameters] { parameters.emplace_back("widen", "true"); },
      "Make strands --every times as wide, to keep their coverage");
  command->add_flag_callback(
      "--no-curves", [&parameters] { parameters.emplace_back("curves", "false"); },
      "Leave out whiskers, lashes and brows");
  command->add_flag_callback(
      "--cubic", [&parameters] { parameters.emplace_back("basis", "cubic"); },
      "USD: cubic curves through the points, not straight lines");
  command->add_flag_callback(
      "--skin", [&parameters] { parameters.emplace_back("skin", "true"); }, "USD: include the model's mesh");
  add_parameter_option(command, parameters, "--frame", "frame",
                       "Axes of the file: source, those of the model's file, or pelage, up +y and front +z [source]");
  add_parameter_option(command, parameters, "--unit", "metres_per_unit", "Metres in one unit of the model's file [1]");
  command->add_flag("--dry-run", options.dry_run, "Print what the file would hold; write nothing");
}

void declare_open(CLI::App& app, Options& options) {
  CLI::App* command = add_action(app, options, Action::open_saved, "open",
                                 "Make a scene from a .pelage file, with its undo log; prints its id");
  command->add_option("file", options.file, "The file, as `pelage export` writes it")->required();
  command->add_option("--name", options.name, "Name, 1 to 200 bytes [the file's own]")->default_str("");
}

void declare_guides(CLI::App& app, Options& options) {
  CLI::App* guides = add_action(app, options, Action::guides, "guides",
                                "Make fur follow curves of another program, root first, as one undo step");
  add_scene(guides, options);
  guides->add_option("file", options.file, "The curves, .usda, .hair or .json; - for standard input")->required();
  Parameters& parameters = options.guide_parameters;
  add_parameter_option(guides, parameters, "--format", "format", "usda, hair or json [the file's ending]");
  add_parameter_option(guides, parameters, "--coat", "coat", "Name of the coat that follows them [all]");
  add_parameter_option(guides, parameters, "--keys", "keys", "Maximum number of curves used, 1 to 1024 [1024]");
  add_parameter_option(guides, parameters, "--sigma", "sigma",
                       "Width over which one curve acts, in sizes [from their spacing]");
  add_parameter_option(guides, parameters, "--strength", "strength", "How far the fur follows the curves, 0 to 1 [1]");
  add_parameter_option(
      guides, parameters, "--frame", "frame",
      "Axes of the file: source, those of the model's file, or pelage, up +y and front +z [source; pelage of json]");
  add_parameter_option(guides, parameters, "--unit", "metres_per_unit",
                       "Metres in one unit of the model's file, to scale a USD [1 for glTF; else unscaled]");
}

void add_map(CLI::App* command, Options& options) {
  add_scene(command, options);
  command->add_option("field", options.field, "direction, length, density, mask or another field")->required();
  Parameters& parameters = options.map_parameters;
  add_parameter_option(command, parameters, "--coat", "coat",
                       "Name of the coat whose field it is [get: the first, put: all]");
  add_parameter_option(command, parameters, "--encoding", "encoding",
                       "direction: uv_tangent, fast_fur or vector; others: value; .npy: vertices");
  add_parameter_option(
      command, parameters, "--scale", "scale",
      "Field value of 1 in the picture [get: the largest value for PNG, else 1; put: from the file, or 1]");
  add_parameter_option(command, parameters, "--units", "units",
                       "Of --scale for lengths: relative (sizes) or world [relative]");
  add_parameter_option(command, parameters, "--tile", "tile", "UDIM tile of the picture, from 1001; 0 for all [0]");
}

void declare_map_get(CLI::App& map, Options& options) {
  CLI::App* get = add_action(map, options, Action::get_map, "get", "Write a field as a picture");
  add_map(get, options);
  get->add_option("-o,--output", options.output, "The picture, .png, .exr or .npy; - for standard output")->required();
  Parameters& parameters = options.map_parameters;
  add_parameter_option(get, parameters, "--format", "format",
                       "png, png16, exr, exr_half or npy [the output's ending, png16 for .png]");
  add_parameter_option(get, parameters, "--size", "size", "Width and height in pixels, 1 to 8192 [1024]");
  add_parameter_option(get, parameters, "--dilate", "dilate", "Pixels that islands grow over their seams, 0 to 64 [8]");
}

}  // namespace

void declare_file_actions(CLI::App& app, Options& options) {
  declare_export(app, options);
  declare_open(app, options);
  declare_guides(app, options);
  CLI::App* map = app.add_subcommand("map", "Fields as pictures, laid out by texture coordinates");
  map->require_subcommand(1);
  map->fallthrough();
  declare_map_get(*map, options);

  CLI::App* put = add_action(*map, options, Action::put_map, "put", "Read a field from a picture, as one undo step");
  add_map(put, options);
  put->add_option("file", options.file,
                  "PNG, JPEG, EXR or HDR, up to 4096 pixels a side, or a NumPy array; - for standard input")
      ->required();
  add_parameter_option(put, options.map_parameters, "--strength", "strength",
                       "Blend from the field to the picture, 0 to 1 [1]");

  CLI::App* keep = add_action(*map, options, Action::put_picture, "upload",
                              "Upload a picture for commands such as mask; prints its name");
  add_scene(keep, options);
  keep->add_option("file", options.file, "The picture; - for standard input")->required();
}

}  // namespace pelage
