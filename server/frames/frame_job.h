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
#include "server/frames/linear_picture.h"
#include "server/frames/shown_scene.h"

namespace pelage {

struct DrawnFrame {
  DrawnPicture picture;
  ModelPlacement placement;
  Revision revision = 0;
  FrameTimings timings;
  FrameCounters counters;
  std::shared_ptr<const FurFrame> frame;  // with the knobs as used
  std::optional<FrameEstimate> estimate;
  FrameCost cost;  // as expected
};

/// A frame that waits for the render thread or is drawn there.
struct FrameJob {
  std::shared_ptr<Scene> scene;
  FrameRequest request;
  std::function<bool()> abandoned;
  bool dry_run = false;
  bool linear = false;  // the picture is its AOVs, linear_aovs(request), whatever the format
  FramePast past = {};
  Stopwatch asked = {};
  std::promise<Result<DrawnFrame>> answer;
  CoatBaker::Handle coat = {};  // that it waits for, or has waited for
  bool put_back = false;        // it was taken before its coat was there
  // While it is drawn:
  double cost = 0;      // as expected, milliseconds
  double expected = 0;  // the same once its view is known
  Stopwatch begun = {};
  Revision revision = 0;
  std::optional<double> moment = {};  // of fur that the wind moves
  bool outdated = false;              // a frame that was let in shows another revision of the scene, or another moment
  bool given_up = false;
  bool overdue = false;  // drawing has taken longer than its request allows
  int restarts = 0;
  int lost_contexts = 0;  // while it was drawn
  double paused = 0;      // milliseconds

  bool left() const { return abandoned && abandoned(); }
  /// Returns whether the render thread has something to do for it.
  bool ready() const { return !coat || coat->settled() || left(); }
  bool same_view(const FrameJob& other) const {
    return !request.view.empty() && scene == other.scene && request.view == other.request.view;
  }
  /// Returns whether both draw what the renderer has of one scene, which changes with the scene.
  bool same_subject(const FrameJob& other) const { return scene == other.scene && past.copy == other.past.copy; }
  bool shows_same(const FrameJob& other) const { return revision == other.revision && moment == other.moment; }
};

/// Refuses (invalid, "/max_seconds") what is expected to take longer than was asked for.
Status check_seconds(const FrameRequest& request, const FrameCost& cost);
/// The refusal of what has taken longer, though it was expected not to.
Status too_slow(const FrameRequest& request, const FrameCost& cost);

/// `cost`: in milliseconds, as expected before its view was known.
FrameProgress progress_of(const FrameJob& job, double cost, bool is_drawn);

}  // namespace pelage
