// The frame service: one render thread, which owns the GL context, and the queue in front of it.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"
#include "renderer/gl/context/context.h"
#include "renderer/image/image.h"
#include "server/frames/frame_job.h"
#include "server/frames/frame_order.h"
#include "server/frames/picture_tracer.h"
#include "server/frames/shown_scene.h"
#include "server/frames/yield_gate.h"
#include "server/scene/scene.h"

namespace pelage {

struct FrameAnswer {
  std::string bytes;
  const char* content_type = "";
  Revision revision = 0;
  Knobs knobs;  // the knobs used
  FrameTimings timings;
  FrameCounters counters;
  std::optional<TraceReport> trace = {};       // set for a traced picture and for a request with progressive
  std::optional<FrameEstimate> estimate = {};  // set if the knobs were planned or are a row of the dial
  std::string missed = {};                     // names of the request's goals that the picture missed (missed_goals)
};

/// Makes the texts of a picture's file from the answer without its bytes; null for no texts.
using FileTexts = std::function<std::vector<ImageText>(const FrameAnswer&)>;

/// The start of tracing a picture: the scene's state and the backplate, of one revision.
struct TraceStart {
  ShownScene shown = {};
  Backplate base = {};
  FrameTimings timings = {};
  FrameCounters counters = {};
};

/// Thread-safe.
class FrameService {
 public:
  /// Starts the render thread and opens its context there. Fails (unavailable), listing the attempts, if a requested GL
  /// does not work. `threads` is the maximum number of CPU threads that draw, 0 for all cores. Work that yields at the
  /// gate waits while frames are drawn and encoded. Coats that are baked at the same time take at most `coat_memory`
  /// bytes together; a single one is always baked. If a context is lost, it is opened again and its frame is drawn
  /// again; if that fails twice, the frame is refused (unavailable). If no GL is available any more, later frames are
  /// drawn as by a server without GL.
  static Result<std::unique_ptr<FrameService>> start(ContextSource contexts, int threads, YieldGate& gate,
                                                     std::size_t coat_memory = std::numeric_limits<std::size_t>::max());
  ~FrameService();

  /// Sets the calibration by which later frames are planned; until then default_calibration applies.
  void set_calibration(Calibration calibration);
  /// Returns the number of CPU threads that draw.
  int threads() const;

  /// Returns the state of the scene that the frame shows (view_of).
  Result<FrameView> view(const Scene& scene, const FrameRequest& request);
  /// Chooses the knobs if the request has a budget or an error, and estimates the cost; on the caller's thread. Refuses
  /// (invalid) a frame expected to take longer than allowed ("/max_seconds"), and knobs that this server cannot draw
  /// with.
  Result<FramePlan> plan(const FrameView& view, const FrameRequest& request) const;
  /// Draws and finishes a frame. Scenes take turns, and short frames of a scene go before its long ones; they are also
  /// drawn in the pauses of a running frame. A frame whose scene changes meanwhile restarts. A missing coat is baked in
  /// the background, once for all who wait for it. Fails with conflict if a newer request of the same scene and named
  /// view supersedes the frame, and with unavailable if it was abandoned, which is checked before drawing starts and in
  /// its pauses. Refuses (invalid, "/max_seconds") a frame that takes longer than allowed.
  Result<DrawnFrame> draw(FrameOrder order);
  /// Encodes the picture's file, on the caller's thread, while other frames are drawn.
  FrameAnswer encode(DrawnFrame drawn, const FrameRequest& request, const FileTexts& texts = {});

  /// Draws a frame in linear light, without finishing it: combines `view`, `plan` and `draw`.
  Result<LinearPicture> draw_linear(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                    const std::function<bool()>& abandoned = {});

  /// Returns the scene's frames that are being drawn or wait.
  FrameProgressList progress(const Scene& scene) const;

  /// Prepares tracing of the scene at present, or at the request's revision, and draws the backplate. Waits until no
  /// frame is being drawn or could be; frames whose coat is still being baked do not count. Fails as `view` and the
  /// renderer do.
  Result<TraceStart> begin_trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request);
  /// Finishes a linear picture as the request says that it was drawn or traced for. Fails (conflict) if an overlay
  /// shows fields of a model that the scene no longer has. Waits as `begin_trace` does.
  Result<DrawnFrame> finish(const LinearPicture& linear, const FrameRequest& request);

  /// Returns the bytes of memory of the renderer's copies of a model, with their GL objects, as of its last frame, plus
  /// those of its cached earlier revisions. Does not wait for frames.
  std::size_t copy_bytes(std::uint64_t model_id) const;
  /// Returns the bytes of memory of baked coats and of those being baked.
  std::size_t coat_bytes() const;
  /// Returns the number of coats baked since the start.
  std::uint64_t coats_baked() const;
  /// Returns the bytes of all GL objects, as of the last frame.
  std::size_t gl_bytes() const;
  /// Drops the renderer's copies of a removed model and of its earlier revisions.
  void forget(std::uint64_t model_id);

  /// Returns a description of what draws now (drawn_by).
  std::string description() const;
  /// Returns false once drawing has failed for a reason other than the frame itself; the server is then not ready.
  bool healthy() const;
  /// Returns how many times the GL context was lost.
  std::size_t lost_contexts() const;
  std::size_t frames_drawn() const;
  double seconds_drawing() const;

 private:
  struct Impl;
  explicit FrameService(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
