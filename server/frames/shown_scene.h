// A scene as one frame shows it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "renderer/quality/view_features.h"
#include "server/fields/field_set.h"
#include "server/frames/frame_parts.h"
#include "server/frames/moved_fur.h"
#include "server/frames/past_scenes.h"
#include "server/scene/scene.h"

namespace pelage {

/// What is drawn of a scene, and which of it.
struct Shown {
  FurFrame fur;
  ModelPlacement placement;
  Revision revision = 0;
  std::uint64_t copy_id = 0;          // SceneView::copy_id
  std::optional<double> moment = {};  // of fur that the wind moves
  MovedDirection direction = {};
  std::optional<SceneCopy> copy = {};
  std::optional<ViewFeatures> features = {};  // where the frame is planned or can be estimated
};

/// What a frame needs of its scene's past.
struct FramePast {
  PastCopy copy = {};                       // what is drawn; null for the scene as it is
  std::optional<PastFields> compared = {};  // what the overlay compares with
};

/// Brings the renderer's copy of the scene, or of its past, up to date; all of the answer is of one revision. A scene
/// that has left the asked revision since past_of is drawn from a copy, which `past` then has. Conflict where the
/// overlay compares with fields of a model that the scene no longer has.
Result<Shown> show(Renderer& renderer, Scene& scene, const FrameRequest& request, FramePast& past, PastScenes& scenes,
                   MovedFur& fur, bool with_copy, bool with_features);

/// Read by whoever asks, where it holds up no other frame.
Result<FramePast> past_of(const Scene& scene, const FrameRequest& request, PastScenes& scenes);

// What two states of the fields differ in, as one number for each vertex.

/// Returns for each vertex how much it changed: the largest over all fields of |change| / reference, clamped to 1. The
/// reference is 1 for direction and colours (the change is the length of the difference), the longest fur of either
/// state for length, and the range for other fields. The result is above 0 wherever any value differs, and 0 elsewhere.
/// Both sets have the same vertices.
std::vector<float> change_shares(const FieldSet& from, const FieldSet& to);

}  // namespace pelage
