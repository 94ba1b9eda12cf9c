// A job of pelage-render: a scene, how it changes over frames, and the files that it is rendered to.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/command.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/scene.h"

namespace pelage {

/// How a parameter changes from key to key. step: it stays until the next key. linear: it goes straight to the next
/// key. spline: it follows a curve that never leaves the range of the two keys beside it (monotone cubic Hermite,
/// Fritsch and Carlson 1980).
enum class KeyInterpolation { step, linear, spline };

/// `value` is JSON: a number, a list of numbers or a colour; with `step` also any text or boolean.
struct ParameterKey {
  double frame = 0;
  std::string value;
};

/// The keys of one parameter over frames. Before the first key it has the value of that key, after the last key the
/// value of the last.
struct ParameterKeys {
  std::string parameter;  // JSON pointer: /frame/..., or a member of the scene's settings, as /lights/0/intensity
  KeyInterpolation interpolation = KeyInterpolation::linear;
  std::vector<ParameterKey> keys;  // at least one, frames ascend
};

/// model: the model turns, and the lights stay fixed to the picture. camera: the camera moves around the model, and the
/// lights stay fixed to the model.
enum class Turning { model, camera };

/// A turn about the vertical axis through the camera's target. The last frame is one step short of `degrees`, so that
/// the clip loops.
struct Turntable {
  double degrees = 360;
  Turning turns = Turning::model;
};

/// How the scene's model moves, with the groom on it: by numbered files, one for each frame, or by an animation of one
/// file.
struct JobMotion {
  std::string model;                   // "walk.####.obj", # are the digits of the frame; or a file with the animation
  std::string animation;               // name of an animation of that file; frame f shows it at f / fps seconds
  std::optional<double> loop_seconds;  // period after which it begins again, (0, 1e6]; none: it plays once
  double inertia = 0;                  // [0, 10], how much of the body's acceleration the fur feels
};

/// Blurs what moves: each frame is the mean, in linear light, of several pictures taken while the shutter is open.
struct MotionBlur {
  double shutter = 0.5;  // exposure time in frames, (0, 4], centred on the frame's time; .5 is 180 degrees
  int samples = 8;       // number of pictures, evenly spaced in time, [2, 256]
};

/// The tiles of about equal size in which each frame is drawn, [1, 16] in each direction.
struct TileGrid {
  int columns = 1, rows = 1;
};

struct RenderJob {
  std::string scene;                     // file of a scene (.pelage) or of a model; "" if `builtin` is set
  std::optional<ImportOptions> options;  // for a model's file only
  std::optional<BuiltinModel> builtin;
  std::vector<Command> commands;  // run once, before the first frame
  std::string frames = "1";       // "1-100", "1-100x5" or "1,4,9"; turntable and time lapse span them
  double fps = 24;                // [0.001, 1000]; frame f is at f / fps seconds
  std::string output;             // "fox.####.png": # are the digits of the frame; .png or .exr
  std::string frame = "{}";       // a FrameRequest as JSON
  std::optional<Turntable> turntable;
  bool time_lapse = false;  // true: the frames show the groom from its first revision to its last
  std::vector<ParameterKeys> keyframes;
  std::optional<JobMotion> motion;
  std::optional<MotionBlur> motion_blur;
  std::optional<TileGrid> tiles;  // tiles are drawn one by one, on any node
};

/// A frame with the keyframes applied.
struct AnimatedFrame {
  FrameRequest request;
  std::vector<Command> settings;  // commands that set the animated settings, such as set_lights
};

}  // namespace pelage
