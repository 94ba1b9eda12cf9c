// What the user asked for.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pelage {

enum class Action {
  wait,
  get,
  create,
  load,
  environment,
  skin_texture,
  get_map,
  put_map,
  put_picture,
  guides,
  run,
  frame,
  export_fur,
  open_saved,
  undo,
  redo,
  revert,
  amend,
  branch,
  log,
  pick,
  list,
  remove,
  info,
  subdivide,
  turn,
  rename,
  compare,
  trade,
  farm,
  calibrate,
  completions,
  man
};

using Parameters = std::vector<std::pair<std::string, std::string>>;

struct Options {
  Action action = Action::list;
  std::string server;
  std::string token;
  std::string author;  // of changes, in the log; "" for nobody
  bool json = false;   // print the server's answer as it is
  std::string scene;   // id or name

  // get
  std::string address;       // "/metrics", or below the scene: "settings"
  std::string answer = "-";  // file that takes it
  // create
  std::string name = "scene";
  std::string builtin = "creature";
  int triangles = 5000;
  double wait_seconds = 30;  // of wait
  // create and load
  double length = 0.03;  // sizes
  double inclination = 0.45;
  std::string form;  // of the first fur; the server's choice when empty
  std::string fur_patches = "overlapping";
  bool ground = false;  // whether it is visible at first
  // load, environment, skin_texture, run and amend; "-" is standard input
  std::string file;
  std::string format;     // "" for the file's ending
  std::string up, front;  // "" where the file says it
  std::string pose;
  std::string crease_degrees;        // "" for the server's choice
  std::vector<int> flip, two_sided;  // numbers of parts
  bool discard = false;              // the groom that the scene has
  // list
  bool names = false;
  // environment
  double intensity = 1, turn_degrees = 0;
  std::string colour_space;  // of an environment
  // map
  std::string field;
  Parameters map_parameters;    // as in the address of the map
  Parameters guide_parameters;  // as in the address of guide curves
  // export
  Parameters export_parameters;  // as in the address of the file
  // run, amend, frame and export
  bool dry_run = false;
  Parameters variables;  // of a recipe, as text
  std::optional<std::uint64_t> if_match;
  std::string places;  // file of places by name; "" for none
  bool verbose = false, watch = false;
  // frame and pick
  std::string output = "frame.png";
  Parameters frame;          // as in the address of frame.png
  Parameters trace;          // members of Tracing
  bool progressive = false;  // a rasterized picture, and then traced ones over the same file
  std::optional<int> until_pass;
  std::optional<double> for_seconds;
  std::optional<double> x, y;               // pixels
  std::string ray, farthest, nearest, box;  // numbers with commas; "" where they do not say the place
  bool world = false;                       // those are the model's own coordinates, not shares of its box
  std::string place_name;                   // "" for none
  std::string shell;                        // of completions
  // undo, redo, revert, amend
  std::uint64_t count = 1;  // steps, or the revision
  bool drop = false;        // amend: leave the step out
  // branch
  std::optional<std::uint64_t> revision;  // the present one when not given
  // compare
  std::string reference, test;      // pictures; "-" is standard input
  std::string mask;                 // a picture; "" for the alpha of both
  std::string map;                  // PNG to write; "" for none
  std::string tone_map = "filmic";  // of EXR and HDR: none or filmic
  // trade
  std::vector<std::string> scenes;  // ids or names; none for the built-in ones
  bool quick = false, resume = false;
  int size = 256;      // pixels of a side
  int r2_passes = 64;  // of the truth, traced strands (R2)
  int repeats = 2;     // of each timing
  // calibrate
  Parameters server_options;  // of pelaged, with their dashes
  // log
  bool lines = false;
  std::string other;  // scene that the lines are carried to, by id or name; "" for this one
  // subdivide
  int levels = 1;
  bool masked = false;
};

/// Parses the command line. Gives the exit code instead when that is all there is to do: 0 after --help, 2 when the
/// line is wrong (the reason is printed).
struct ParsedLine {
  std::optional<int> exit_code;
  Options options;
};
ParsedLine parse_line(int argc, char** argv);

}  // namespace pelage
