// The state of a scene that one frame shows.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "server/fields/field_set.h"
#include "server/frames/frame_order.h"
#include "server/frames/frame_parts.h"
#include "server/frames/past_scenes.h"
#include "server/frames/shown_fur.h"
#include "server/scene/scene.h"

namespace pelage {

/// Returns the state of a scene that a request asks for. Reads the journal for earlier revisions. Refuses (invalid,
/// "/revision" or "/overlay_from") revisions that the scene's model does not have.
Result<FrameView> view_of(const Scene& scene, const FrameRequest& request, PastScenes& scenes);

/// A snapshot as it is drawn.
struct ShownScene {
  SnapshotPtr snapshot = {};
  FurFrame fur = {};
  ModelPlacement placement = {};
  std::optional<double> moment = {};  // time of moving fur, seconds
  MovedDirection direction = {};

  Revision revision() const { return snapshot->revision; }
  std::uint64_t copy_id() const { return snapshot->view().copy_id; }
};

/// Updates the renderer's copy of the scene to a snapshot. `compared` is FrameView::compared.
ShownScene sync_snapshot(Renderer& renderer, RendererCopyStates& shown, const SnapshotPtr& snapshot,
                         const FrameRequest& request, const FieldSet* compared = nullptr);

// The difference of two states of the fields, as one number for each vertex.

/// Returns for each vertex how much it changed: the largest over all fields of |change| / reference, clamped to 1. The
/// reference is 1 for direction and colours (whose change is the length of the difference), the longest fur of either
/// state for length, and the range for other fields. The result is above 0 wherever any value differs, and 0 elsewhere.
/// Both sets must have the same vertices.
std::vector<float> change_shares(const FieldSet& from, const FieldSet& to);

}  // namespace pelage
