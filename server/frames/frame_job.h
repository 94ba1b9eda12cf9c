// A frame that waits for the render thread or is drawn there.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <optional>

#include "base/status.h"
#include "base/stopwatch.h"
#include "protocol/commands/quality.h"
#include "server/frames/coat_baker.h"
#include "server/frames/frame_file.h"
#include "server/frames/frame_order.h"
#include "server/frames/linear_picture.h"

namespace pelage {

/// A finished picture, with everything that encoding its file needs.
struct DrawnFrame {
  DrawnPicture picture = {};
  Revision revision = 0;
  std::shared_ptr<const FurFrame> frame = {};  // with the knobs used
  ModelPlacement placement = {};
  FrameTimings timings = {};
  FrameCounters counters = {};
  std::optional<FrameEstimate> estimate = {};  // as in FramePlan
  std::optional<TraceReport> trace = {};       // set for traced strands
};

/// A frame that waits for the render thread or is drawn there.
struct FrameJob {
  FrameOrder order;
  bool linear = false;  // the result is the AOVs linear_aovs(request), whatever the format
  Stopwatch since_request = {};
  std::promise<Result<DrawnFrame>> answer = {};
  CoatBaker::Handle coat = {};  // the bake that it waits for, or waited for
  bool put_back = false;        // it was taken before its coat was baked, and goes back to the queue
  // State while it is drawn:
  Stopwatch since_start = {};
  std::uint64_t copy_id = 0;  // the renderer's copy of the scene
  Revision revision = 0;
  std::optional<double> moment = {};  // time of moving fur, seconds
  bool outdated = false;              // a frame drawn in between set the renderer's copy to another revision or time
  bool given_up = false;
  bool overdue = false;  // drawing has taken longer than its request allows
  int restarts = 0;
  int lost_contexts = 0;  // while it was drawn
  double paused = 0;      // time spent on frames drawn in between, milliseconds

  double cost() const { return 1e3 * order.plan.cost.seconds; }  // expected, milliseconds
  /// Returns whether the render thread can work on it now.
  bool ready() const { return !coat || coat->settled() || order.is_abandoned(); }
  bool same_view(const FrameJob& other) const {
    return !order.request.view.empty() && order.scene == other.order.scene &&
           order.request.view == other.order.request.view;
  }
  /// Returns the snapshot to draw; to be called when drawing begins.
  SnapshotPtr snapshot() const { return order.view.fixed ? order.view.snapshot : order.scene->snapshot(); }
  bool shows_same(const FrameJob& other) const {
    return revision == other.revision && moment == other.moment && order.request.masked == other.order.request.masked;
  }
};

/// Refuses (invalid, "/max_seconds") a frame expected to take longer than its request allows.
Status check_seconds(const FrameRequest& request, const FrameCost& cost);
/// Returns the error for a frame that took longer than its request allows, although it was not expected to.
Status too_slow(const FrameRequest& request, const FrameCost& cost);

FrameProgress progress_of(const FrameJob& job, bool is_drawn);

}  // namespace pelage
