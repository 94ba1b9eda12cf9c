// A frame on its way to be drawn: what of a scene it shows, with which knobs, and for whom.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "protocol/commands/frame.h"
#include "protocol/commands/quality.h"
#include "server/scene/scene.h"

namespace pelage {

/// What of a scene a frame shows.
struct FrameView {
  SnapshotPtr snapshot;  // of the scene when it was asked for
  /// Returns whether that is drawn, as it is named or compared with; else the newest one when drawing begins.
  bool fixed = false;
  std::shared_ptr<const FieldSet> compared = {};  // what the overlay compares with
};

/// How a frame is drawn, and what that is expected to cost.
struct FramePlan {
  Knobs knobs;
  std::optional<FrameEstimate> estimate = {};  // none of knobs that are no row of the dial
  FrameCost cost = {};
};

struct FrameOrder {
  std::shared_ptr<Scene> scene;
  FrameRequest request;
  FrameView view;
  FramePlan plan;
  std::function<bool()> abandoned = {};  // whether nobody waits any more; empty for never

  bool left() const { return abandoned && abandoned(); }
};

}  // namespace pelage
