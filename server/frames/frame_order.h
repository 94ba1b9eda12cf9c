// A frame to be drawn: the scene's state, the knobs and the client.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"
#include "server/scene/scene.h"

namespace pelage {

/// The state of a scene that a frame shows.
struct FrameView {
  SnapshotPtr snapshot;  // the scene's state at the time of the request
  /// True if `snapshot` itself must be drawn, because the request names it or compares it with another state; else the
  /// newest state is drawn.
  bool fixed = false;
  std::shared_ptr<const FieldSet> compared = {};  // the fields that the overlay compares with
};

/// The knobs of a frame, and its expected cost.
struct FramePlan {
  Knobs knobs;
  std::optional<FrameEstimate> estimate = {};  // absent for knobs that are not a row of the dial
  FrameCost cost = {};
};

struct FrameOrder {
  std::shared_ptr<Scene> scene;
  FrameRequest request;
  FrameView view;
  FramePlan plan;
  std::function<bool()> abandoned = {};  // returns whether nobody waits any more; empty for never

  bool is_abandoned() const { return abandoned && abandoned(); }
};

}  // namespace pelage
