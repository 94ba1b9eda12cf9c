// A job of pelage-render: a scene, how it changes over frames, and the files that are drawn of it.
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

/// `value` is JSON: a number, a list of numbers or a colour; for `step` any text or boolean too.
struct ParameterKey {
  double frame = 0;
  std::string value;
};

/// The keys of one parameter over frames. Before its first key it has that key's value, after its last key the last
/// one's.
struct ParameterKeys {
  std::string parameter;  // JSON pointer: /frame/..., or a member of the scene's settings, as /lights/0/intensity
  KeyInterpolation interpolation = KeyInterpolation::linear;
  std::vector<ParameterKey> keys;  // at least one, frames ascend
};

/// model: the model turns, and the lights stay where they are on the picture. camera: the camera moves around the
/// model.
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
  std::string animation;               // of that file, by its name; frame f shows its second f / fps
  std::optional<double> loop_seconds;  // (0, 1e6], after which it begins again; none: it stays where it ends
  double inertia = 0;                  // [0, 10], how much of the body's acceleration the fur feels
};

/// Makes each frame the mean, in linear light, of pictures while a shutter is open, so that whatever moves is blurred.
struct MotionBlur {
  double shutter = 0.5;  // frames that it is open, (0, 4], half of them before the frame's time; .5 is 180 degrees
  int samples = 8;       // pictures at moments spread evenly, [2, 256]
};

/// The tiles of about equal size in which each frame is drawn, [1, 16] in each direction.
struct TileGrid {
  int columns = 1, rows = 1;
};

struct RenderJob {
  std::string scene;                     // file of a scene (.pelage) or of a model; "" where there is `builtin`
  std::optional<ImportOptions> options;  // of a model's file
  std::optional<BuiltinModel> builtin;
  std::vector<Command> commands;  // run once, before the first frame
  std::string frames = "1";       // "1-100", "1-100x5", "1,4,9": what turntable and time lapse go over
  double fps = 24;                // [0.001, 1000]; frame f is at f / fps seconds
  std::string output;             // "fox.####.png": # are the digits of the frame; .png or .exr
  std::string frame = "{}";       // FrameRequest, JSON
  std::optional<Turntable> turntable;
  bool time_lapse = false;  // the groom from its first revision to its last, over the frames
  std::vector<ParameterKeys> keyframes;
  std::optional<JobMotion> motion;
  std::optional<MotionBlur> motion_blur;
  std::optional<TileGrid> tiles;  // each drawn by itself, on whatever node
};

/// What keyframes make of one frame.
struct AnimatedFrame {
  FrameRequest request;
  std::vector<Command> settings;  // that lead there, set_lights and the like
};

}  // namespace pelage
