#include <CLI/CLI.hpp>

#include "clients/cli/line/declare.h"

namespace pelage {

namespace {

void add_fur(CLI::App* command, Options& options) {
  command->add_option("--length", options.length, "Length of the first fur, in sizes of the model, 0 to 10")
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
  command->add_flag("--ground", options.ground, "Begin with a visible ground below the model");
}

/// Adds the options that say how a model file is read.
void add_import(CLI::App* command, Options& options) {
  command->add_option("--format", options.format, "obj, ply, stl, off, gltf, glb, 3ds or zip [the file's ending]");
  command->add_option("--up", options.up,
                      "Axis of the file that is up: x, -x, y, -y, z or -z [z of stl and 3ds, else y]");
  command->add_option("--front", options.front,
                      "Axis of the file that the model faces [from left and right joints; else -y if z is up, else z]");
  command->add_option("--pose", options.pose, "NAME@SECONDS of a glTF's animation: the pose to load");
  command->add_option("--crease-degrees", options.crease_degrees,
                      "Shade edges sharper than this as hard edges, 0 to 180; 180: none [60]");
  command->add_option("--flip", options.flip, "Number of a part to turn inside out; loading reports doubtful parts");
  command->add_option("--two-sided", options.two_sided,
                      "Number of a one-layer part to grow fur on both sides; loading reports sheets");
}

void declare_new(CLI::App& app, Options& options) {
  CLI::App* create = add_action(app, options, Action::create, "new",
                                "Make a scene with a built-in model or one from a file; prints its id");
  create->add_option("--name", options.name, "Name, 1 to 200 bytes")->capture_default_str();
  CLI::Option* builtin =
      create->add_option("--builtin", options.builtin, "torus, knot, sphere, plane, cloth or creature")
          ->capture_default_str();
  create->add_option("--triangles", options.triangles, "About how many triangles a built-in model has")
      ->capture_default_str();
  create->add_option("--file", options.file, "Model file to load instead, as `pelage load` does")->excludes(builtin);
  add_import(create, options);
  add_fur(create, options);
}

void declare_load(CLI::App& app, Options& options) {
  CLI::App* load =
      add_action(app, options, Action::load, "load",
                 "Load a model file, with the files it names, into a scene. A groomed scene keeps its groom; its "
                 "undo log starts empty, and its old state stays as another scene");
  add_scene(load, options);
  load->add_option("file", options.file, "The model; - for standard input")->required();
  CLI::Option* discard =
      load->add_flag("--discard", options.discard, "Start with a new first groom; the scene's groom is lost");
  const std::string keeps = "Transfer the groom to the new model, the default for a groomed scene";
  load->add_flag("--keep", keeps)->excludes(discard);
  add_import(load, options);
  add_fur(load, options);
}

void declare_environment(CLI::App& app, Options& options) {
  CLI::App* environment = add_action(app, options, Action::environment, "environment",
                                     "Light a scene with an environment map: EXR or HDR of 360 by 180 degrees");
  add_scene(environment, options);
  environment->add_option("file", options.file, "The picture, up to 4096 pixels a side; - for standard input")
      ->required();
  environment->add_option("--colour-space", options.colour_space,
                          "The picture's linear space in the server's OpenColorIO configuration [linear Rec. 709]");
  environment->add_option("--intensity", options.intensity, "Factor on its light, 0 to 100")->capture_default_str();
  environment
      ->add_option("--turn-degrees", options.turn_degrees, "Turn about +y, counter-clockwise from above, -360 to 360")
      ->capture_default_str();
}

}  // namespace

void declare_scene_actions(CLI::App& app, Options& options) {
  declare_new(app, options);
  add_action(app, options, Action::list, "list", "List the scenes")
      ->add_flag("--names", options.names, "Print only their names, one a line");
  add_scene(add_action(app, options, Action::info, "info", "Describe a scene"), options);
  add_scene(add_action(app, options, Action::remove, "rm", "Remove a scene"), options);
  CLI::App* rename = add_action(app, options, Action::rename, "rename", "Give a scene another name; its id stays");
  add_scene(rename, options);
  rename->add_option("name", options.name, "The name, 1 to 200 bytes")->required();
}

void declare_model_actions(CLI::App& app, Options& options) {
  declare_load(app, options);
  declare_environment(app, options);

  CLI::App* skin = add_action(app, options, Action::skin_texture, "skin-texture",
                              "Lay a PNG or JPEG on a model by its texture coordinates");
  add_scene(skin, options);
  skin->add_option("file", options.file, "The picture, up to 4096 pixels a side; - for standard input")->required();

  CLI::App* subdivide = add_action(app, options, Action::subdivide, "subdivide",
                                   "Split the model's triangles into four; fields stay, the undo log starts empty");
  add_scene(subdivide, options);
  subdivide->add_option("--levels", options.levels, "How many times, 1 to 8")->capture_default_str();
  subdivide->add_flag("--masked", options.masked, "Only triangles with a corner whose mask is above 0.5");

  CLI::App* turn = add_action(app, options, Action::turn, "turn",
                              "Turn a scene's model and fur to other axes; the undo log starts empty");
  add_scene(turn, options);
  turn->add_option("--up", options.up, "The model's present axis that is to point up: x, -x, y, -y, z or -z [y]");
  turn->add_option("--front", options.front, "The present axis that is to point forward, not along --up [z]");
}

}  // namespace pelage
