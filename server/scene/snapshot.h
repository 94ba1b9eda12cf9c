// A scene at a revision: what everybody reads who draws, traces, picks, exports or lists. Nothing of it changes, so
// that nobody who reads a scene ever waits for it.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/scene.h"
#include "protocol/commands/settings.h"
#include "server/fields/field_set.h"
#include "server/patches/patches.h"
#include "server/patches/subdivide.h"
#include "server/surface/surface.h"

namespace pelage {

/// A model that never changes while it is in a scene; shared with frames that are being drawn.
struct SceneModel {
  Surface surface;
  PatchMap patches;
  std::uint64_t id = 0;  // unique in the process: what the renderer caches by, but for branches that share the model
  std::string name;      // "creature", "obj", ...
  FurPatches fur_patches = FurPatches::overlapping;
  std::vector<ChosenTriangles> subdivisions = {};  // since it was prepared
  std::string mesh_id = {};                        // SceneSummary::model_id
  std::shared_ptr<const SceneModel> rest = {};     // of one that has moved: as its coat was made, vertex by vertex
};

/// How a model that moves has moved, which makes its fur swing.
struct BodySwing {
  /// Returns the acceleration of the skin at a vertex at a time of the scene, sizes per second squared, rotated as the
  /// skin has been since then: the form that BodyMotion (server/motion) takes. Called from several threads.
  std::function<glm::dvec3(std::uint32_t vertex, double time)> acceleration;
  double step = 1.0 / 24;  // seconds, [1/1000, 1], from one known acceleration to the next
};

/// The pose of a scene at a moment: its model, moved, and its settings, moved along. The groom stays as it is.
struct ScenePose {
  std::shared_ptr<const SceneModel> model;  // with the triangles of the scene's
  SceneSettings settings;
  std::optional<BodySwing> swing = {};
};

/// What drawing needs to read of a scene.
struct SceneView {
  const SceneModel& model;
  const FieldSet& fields;
  const SceneSettings& settings;
  Revision revision;
  const RawImage* skin_texture = nullptr;  // that the settings name; null for the model's own colours
  std::uint64_t copy_id = model.id;        // by which the renderer caches the model with these fields
  const BodySwing* swing = nullptr;        // null for a model that stands still
  bool masked = false;                     // FrameRequest::masked
};

/// All vertices of a model.
inline std::vector<VertexRange> whole_range(std::size_t vertices) {
  return {{0, static_cast<std::uint32_t>(vertices)}};
}

/// Which vertices the last changes of a scene touched, so that whoever has drawn an older snapshot takes over no
/// others.
class RecentChanges {
 public:
  static constexpr std::size_t max_known = 256;

  /// The number of the last change; 0 before the first.
  std::uint64_t number() const { return number_; }
  /// The same with one more change.
  RecentChanges with(std::vector<VertexRange> touched) const;
  /// Returns the vertices that changes after a number have touched, in order and without overlaps; nothing where that
  /// is no longer known.
  std::optional<std::vector<VertexRange>> since(std::uint64_t number) const;

 private:
  std::uint64_t number_ = 0;
  std::vector<std::shared_ptr<const std::vector<VertexRange>>> known_;  // the newest comes last
};

struct SceneSnapshot {
  std::shared_ptr<const SceneModel> model;
  std::shared_ptr<const FieldSet> fields;
  std::shared_ptr<const SceneSettings> settings;
  Revision revision = 0;
  std::uint64_t copy_id = 0;  // SceneView::copy_id of a scene that is not posed
  std::shared_ptr<const RawImage> skin_texture = {};
  std::shared_ptr<const ScenePose> pose = {};
  RecentChanges changes = {};

  /// Returns the scene as it is posed. Valid as long as the snapshot lives.
  SceneView view(bool masked = false) const;
  /// An estimate of what it takes beside the model. A picture that the scene has too counts here as well.
  std::size_t bytes() const;
};

using SnapshotPtr = std::shared_ptr<const SceneSnapshot>;

/// The groom of a scene at a revision of its model, which stays whatever becomes of the scene.
struct GroomSource {
  std::string scene;
  std::optional<Revision> asked = {};  // the revision that was asked for
  Revision revision = 0;
  std::shared_ptr<const SceneModel> model;
  std::shared_ptr<const FieldSet> fields;
};

}  // namespace pelage
