// The parsed command line.
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
  std::string author;  // name recorded in the log with each change; "" for none
  bool json = false;   // print the server's answer as JSON
  std::string scene;   // id or name

  // get
  std::string address;       // URL path below the scene ("settings"); "" if `scene` holds a whole path ("/metrics")
  std::string answer = "-";  // output file; "-" is standard output
  // create
  std::string name = "scene";
  std::string builtin = "creature";
  int triangles = 5000;
  double wait_seconds = 30;  // timeout of `wait`
  // create and load
  double length = 0.03;  // of the first fur, in model sizes
  double inclination = 0.45;
  std::string form;  // of the first fur; "" for the server's default
  std::string fur_patches = "overlapping";
  bool ground = false;  // show the ground at first
  // load, environment, skin_texture, run and amend; "-" is standard input
  std::string file;
  std::string format;     // "" to use the file extension
  std::string up, front;  // axes such as "-y"; "" for the format's default
  std::string pose;
  std::string crease_degrees;        // "" for the server's default
  std::vector<int> flip, two_sided;  // part numbers
  bool discard = false;              // drop the scene's groom instead of keeping it on the new model
  // list
  bool names = false;
  // environment
  double intensity = 1, turn_degrees = 0;
  std::string colour_space;
  // map
  std::string field;
  Parameters map_parameters;    // query parameters of the map's URL
  Parameters guide_parameters;  // query parameters of the guide curves' URL
  // export
  Parameters export_parameters;  // query parameters of the export's URL
  // run, amend, frame and export
  bool dry_run = false;
  Parameters variables;  // recipe variables: name and value, as typed
  std::optional<std::uint64_t> if_match;
  std::string places;  // JSON file of named places; "" for none
  bool verbose = false, watch = false;
  // frame and pick
  std::string output = "frame.png";
  Parameters frame;          // query parameters of frame.png
  Parameters trace;          // members of Tracing
  bool progressive = false;  // write a rasterized picture, then overwrite it with traced ones
  std::optional<int> until_pass;
  std::optional<double> for_seconds;
  std::optional<double> x, y;               // pixels
  std::string ray, farthest, nearest, box;  // numbers separated by commas; "" if not given
  bool world = false;                       // those positions are model coordinates, not fractions of its bounding box
  std::string place_name;                   // "" for none
  std::string shell;                        // of completions: bash, zsh or fish
  // undo, redo, revert, amend
  std::uint64_t count = 1;  // number of steps; for revert and amend, a revision
  bool drop = false;        // amend: leave the step out
  // branch
  std::optional<std::uint64_t> revision;  // where the branch begins; the current revision if not given
  // compare
  std::string reference, test;      // picture files; "-" is standard input
  std::string mask;                 // picture file; "" for the union of both alphas
  std::string map;                  // PNG file for the error map; "" for none
  std::string tone_map = "filmic";  // for EXR and HDR files: none or filmic
  // trade
  std::vector<std::string> scenes;  // ids or names; empty for the built-in scenes
  bool quick = false, resume = false;
  int size = 256;      // width and height of the pictures, in pixels
  int r2_passes = 64;  // passes of the reference pictures, which are traced strands (R2)
  int repeats = 2;     // timed frames for each setting; the fastest counts
  // calibrate
  Parameters server_options;  // flags of pelaged, with their dashes, and values
  // log
  bool lines = false;  // print the commands that lead to the current state, as JSON lines
  std::string other;   // id or name of the scene to convert those commands for; "" for this one
  // subdivide
  int levels = 1;
  bool masked = false;
};

/// A parsed command line. `exit_code` is set if the program is to end at once: 0 if parsing printed all that was asked
/// for (--help, man, completions), 2 if the line is wrong (the reason has been printed).
struct ParsedLine {
  std::optional<int> exit_code;
  Options options;
};
ParsedLine parse_line(int argc, char** argv);

}  // namespace pelage
