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

/// A picture as it is finished, with all that its file needs.
struct DrawnFrame {
  DrawnPicture picture = {};
  Revision revision = 0;
  std::shared_ptr<const FurFrame> frame = {};  // with the knobs as used
  ModelPlacement placement = {};
  FrameTimings timings = {};
  FrameCounters counters = {};
  std::optional<FrameEstimate> estimate = {};  // as FramePlan has it
  std::optional<TraceReport> trace = {};       // of traced strands
};

/// A frame that waits for the render thread or is drawn there.
struct FrameJob {
  FrameOrder order;
  bool linear = false;  // the picture is its AOVs, linear_aovs(request), whatever the format
  Stopwatch asked = {};
  std::promise<Result<DrawnFrame>> answer = {};
  CoatBaker::Handle coat = {};  // that it waits for, or has waited for
  bool put_back = false;        // it was taken before its coat was there
  // While it is drawn:
  Stopwatch begun = {};
  std::uint64_t copy_id = 0;  // what the renderer has of the scene
  Revision revision = 0;
  std::optional<double> moment = {};  // of fur that the wind moves
  bool outdated = false;              // a frame that was let in shows another revision of the scene, or another moment
  bool given_up = false;
  bool overdue = false;  // drawing has taken longer than its request allows
  int restarts = 0;
  int lost_contexts = 0;  // while it was drawn
  double paused = 0;      // milliseconds

  double cost() const { return 1e3 * order.plan.cost.seconds; }  // as expected, milliseconds
  /// Returns whether the render thread has something to do for it.
  bool ready() const { return !coat || coat->settled() || order.left(); }
  bool same_view(const FrameJob& other) const {
    return !order.request.view.empty() && order.scene == other.order.scene &&
           order.request.view == other.order.request.view;
  }
  /// What is drawn, when drawing begins.
  SnapshotPtr snapshot() const { return order.view.fixed ? order.view.snapshot : order.scene->snapshot(); }
  bool shows_same(const FrameJob& other) const {
    return revision == other.revision && moment == other.moment && order.request.masked == other.order.request.masked;
  }
};

/// Refuses (invalid, "/max_seconds") what is expected to take longer than was asked for.
Status check_seconds(const FrameRequest& request, const FrameCost& cost);
/// The refusal of what has taken longer, though it was expected not to.
Status too_slow(const FrameRequest& request, const FrameCost& cost);

FrameProgress progress_of(const FrameJob& job, bool is_drawn);

}  // namespace pelage
