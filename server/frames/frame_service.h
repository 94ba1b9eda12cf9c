// Frames: the one render thread, which owns the one GL context, and the queue in front of it.
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
  Knobs knobs;  // as used
  FrameTimings timings;
  FrameCounters counters;
  std::optional<TraceReport> trace = {};       // of a traced picture, and of a request with progressive
  std::optional<FrameEstimate> estimate = {};  // of shells whose knobs were planned or are a row of the dial
  std::string missed = {};                     // missed_goals of the request
};

/// Texts that the file of a picture carries, by all of the answer but its bytes; null for none.
using FileTexts = std::function<std::vector<ImageText>(const FrameAnswer&)>;

/// Everything that a picture is traced from, all of one revision.
struct TraceStart {
  Shown shown = {};
  Backplate base = {};
  FrameTimings timings = {};
  FrameCounters counters = {};
};

/// Thread-safe.
class FrameService {
 public:
  /// Starts the render thread and opens its context there. Fails (unavailable), saying what was tried, if a GL that was
  /// asked for does not work. `threads` is the maximum number of threads that the CPU draws on, 0 for all cores. Work
  /// that yields at the gate waits while frames are drawn and encoded. Coats that are baked at the same time take at
  /// most `coat_memory` bytes together; one alone is always baked. If a context is lost, it is opened again and its
  /// frame is drawn again; if that fails twice, the frame is refused (unavailable). If there is no GL any more, the
  /// next frames are drawn as by a server without one.
  static Result<std::unique_ptr<FrameService>> start(ContextSource contexts, int threads, YieldGate& gate,
                                                     std::size_t coat_memory = std::numeric_limits<std::size_t>::max());
  ~FrameService();

  /// Sets the calibration that frames are planned by from now on; until the first call the safe defaults apply.
  void plan_by(Calibration calibration);
  /// Returns the number of threads that the CPU draws on.
  int threads() const;

  /// What of the scene the frame shows (view_of).
  Result<FrameView> view(const Scene& scene, const FrameRequest& request);
  /// Chooses the knobs where a budget or an error is asked for, and estimates the cost; on the caller's thread. Refused
  /// (invalid) where drawing is expected to take longer than asked ("/max_seconds"), and where nothing draws with such
  /// knobs.
  Result<FramePlan> plan(const FrameView& view, const FrameRequest& request) const;
  /// Draws what the order plans, and finishes it. Scenes take turns, and short frames of a scene go before its long
  /// ones; they are let in between the pieces of a frame that is being drawn. A frame whose scene changes meanwhile
  /// begins anew. A coat that is not there yet is baked in the background, once for all who wait for it. Returns
  /// conflict if a newer request of the same scene and named view supersedes the frame. It is asked whether the frame
  /// was abandoned before drawing starts and between pieces; a frame that nobody waits for is dropped (unavailable).
  /// Refused (invalid, "/max_seconds") if drawing takes longer than asked.
  Result<DrawnFrame> draw(FrameOrder order);
  /// Makes the picture's file. On the caller's thread, while other frames are drawn.
  FrameAnswer encode(DrawnFrame drawn, const FrameRequest& request, const FileTexts& texts = {});

  /// A frame's light before it is finished: `view`, `plan` and `draw`.
  Result<LinearPicture> light(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                              const std::function<bool()>& abandoned = {});

  /// The scene's frames that are drawn or wait.
  FrameProgressList progress(const Scene& scene) const;

  /// Prepares tracing of the scene as it is now, or at the request's revision; draws what lies under the strands. Waits
  /// until no frame is drawn or waits. Refused as `frame` is.
  Result<TraceStart> begin_trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request);
  /// Finishes light by the request that it was drawn or traced for. Conflict where an overlay shows fields of a model
  /// that the scene no longer has. Waits until no frame does.
  Result<DrawnFrame> finish(const LinearPicture& light, const FrameRequest& request);

  /// Returns the bytes of memory that the renderer's copies of a model take, with their GL objects, as of its last
  /// frame, plus those of its cached earlier revisions. Waits for no frame.
  std::size_t copy_bytes(std::uint64_t model_id) const;
  /// Returns the bytes of memory that baked coats take, and those that are being baked.
  std::size_t coat_bytes() const;
  /// Since the start.
  std::uint64_t coats_baked() const;
  /// Storage of all GL objects, as of the last frame.
  std::size_t gl_bytes() const;
  /// Forgets GPU copies of a model that is gone, and its earlier revisions.
  void forget(std::uint64_t model_id);

  /// What draws now (drawn_by).
  std::string description() const;
  /// False once drawing has failed for no reason of the frame's; the server is then not ready.
  bool healthy() const;
  /// Returns how many times the GL was lost.
  std::size_t lost_contexts() const;
  std::size_t frames_drawn() const;
  double seconds_drawing() const;

 private:
  struct Impl;
  explicit FrameService(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
