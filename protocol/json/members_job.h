// JSON members of a job file of pelage-render.
#pragma once

#include "protocol/commands/job.h"
#include "protocol/json/members.h"
#include "protocol/json/members_frame.h"
#include "protocol/json/members_scene.h"

namespace pelage::json_parts {

inline constexpr Range frame_number{-1e6, 1e6, "frames"};
inline constexpr Count job_keys{1, 10'000};

template <class V>
void members(V& v, Visited<V, ParameterKey>& c) {
  v.type("ParameterKey", "The value of a parameter at a frame.");
  v.number(required("frame"), c.frame, frame_number, "Frame number; may lie between two frames.");
  v.any(required("value"), c.value,
        "Value at that frame: a number, a list of numbers or a colour; with interpolation `step` also a word or a "
        "boolean.");
}

template <class V>
void members(V& v, Visited<V, ParameterKeys>& c) {
  v.type("ParameterKeys", "One parameter over the frames. It is constant before its first key and after its last.");
  v.label(required("parameter"), c.parameter,
          "JSON pointer to what changes: `/frame/...` for a member of the job's `frame`, else a member of the scene's "
          "settings, as `/lights/0/intensity` or `/coats/0/coat/width_root`.");
  v.name("interpolation", c.interpolation, json_names::key_interpolations,
         "How values change between keys. step: constant until the next key. linear: straight. spline: a smooth curve "
         "that never leaves the range of the two keys beside it.");
  v.objects(required("keys"), c.keys, job_keys, "The keys; their frames ascend.");
}

template <class V>
void members(V& v, Visited<V, Turntable>& c) {
  v.type("Turntable",
         "A turn about the vertical axis through the camera's target, over the job's frames. The last frame is one "
         "step short of the end, so that the clip loops.");
  v.number("degrees", c.degrees, {-1e6, 1e6, "degrees"}, "Angle of the turn.");
  v.name("turns", c.turns, json_names::turnings,
         "What turns. model: the lights stay fixed to the picture. camera: they stay fixed to the model.");
}

template <class V>
void members(V& v, Visited<V, JobMotion>& c) {
  v.type("JobMotion",
         "Motion of the scene's model over the frames. Its files have the vertices and faces of the file that the "
         "scene's model came from, in the same order; groom, eyes, curves and bare skin follow.");
  v.text(required("model"), c.model,
         "File of a model beside the job's file: `walk.####.obj`, where # are the digits of the frame, or one file "
         "with the animation.",
         limits::path_bytes);
  v.label("animation", c.animation,
          "Name of an animation of that file. Frame f shows it at f / fps seconds; it holds still before its first key "
          "and after its last.");
  v.number("loop_seconds", c.loop_seconds, {0.001, 1e6, "seconds"},
           "Seconds after which the animation repeats, before frame 0 too. Absent: it plays once.");
  v.number(
      "inertia", c.inertia, {0, 10, ""},
      "How much the body's motion makes the fur swing: 0 not at all, 1 as in nature. A frame then also reads where "
      "the model was in the 4 seconds before it.");
}

template <class V>
void members(V& v, Visited<V, MotionBlur>& c) {
  v.type("MotionBlur",
         "A shutter that is open for a part of a frame: each frame is the mean of pictures at moments spread evenly "
         "over that time, in linear light before exposure and tone mapping.");
  v.number("shutter", c.shutter, {0.001, 4, "frames"},
           "How long it is open, half before the frame's time and half after. 0.5 is a shutter of 180 degrees.");
  v.integer("samples", c.samples, {2, 256, "pictures"},
            "Number of pictures per frame, which takes that many times as long. They share the passes of traced "
            "strands. What moves more than a few pixels from one to the next shows as copies.");
}

template <class V>
void members(V& v, Visited<V, TileGrid>& c) {
  v.type("TileGrid", "Parts of about equal size that a frame is cut into.");
  v.integer("columns", c.columns, {1, limits::job_tiles, "tiles"}, "Tiles side by side; at most the frame's width.");
  v.integer("rows", c.rows, {1, limits::job_tiles, "tiles"}, "Tiles below each other; at most the frame's height.");
}

template <class V>
void members(V& v, Visited<V, RenderJob>& c) {
  v.type("RenderJob",
         "Frames of one scene that `pelage-render` draws into files. What is not given takes its default.");
  v.text("scene", c.scene,
         "File of a scene (`.pelage`) or of a model, beside the job's file. Either this or `builtin`.",
         limits::path_bytes);
  v.object("options", c.options, "How a model's file is read; of a model's file only.");
  v.object("builtin", c.builtin, "A built-in model in place of a file.");
  v.objects("commands", c.commands, {0, limits::commands_per_batch}, "Commands that run once, before the first frame.");
  v.text("frames", c.frames,
         "Frames of the job, as `1-100`, `1-100x5` (every fifth) or `1,4,9`. Turntable and time lapse span them.");
  v.number("fps", c.fps, {0.001, 1000, "frames per second"}, "Frames of a second; frame f is at f / fps seconds.");
  v.text("output", c.output,
         "Files to write, beside the job's file, as `out/fox.####.png`: # are the digits of the frame. The ending says "
         "the format: .png or .exr.",
         limits::path_bytes);
  v.template document<FrameRequest>("frame", c.frame,
                                    "What is drawn, as a request for a frame. `format` may be png16.");
  v.object("turntable", c.turntable, "Turns the model, or the camera about it.");
  v.boolean(
      "time_lapse", c.time_lapse,
      "Whether the frames show the groom from its first revision to its last. Keyframes can then change only `frame`.");
  v.objects("keyframes", c.keyframes, {0, 256}, "Parameters that change over the frames.");
  v.object("motion", c.motion, "Moves the model from frame to frame, with the groom on it.");
  v.object("motion_blur", c.motion_blur,
           "Blurs what moves: the model, fur in the wind, the camera, all that has keyframes. Excludes `time_lapse`, "
           "and in `frame` `budget_ms`, `overlay` and a `shutter` of strands.");
  v.object("tiles", c.tiles,
           "Cuts each frame into tiles that are drawn one by one, also on several nodes. The process that draws the "
           "last tile of a frame merges them into the same file as without tiles. Excludes, in `frame`, `crop`, "
           "`budget_ms` and an end of tracing by `seconds`.");
}

}  // namespace pelage::json_parts
