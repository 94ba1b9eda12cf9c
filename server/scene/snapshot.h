// An immutable snapshot of a scene at a revision. All code that draws, traces, picks, exports or lists reads snapshots
// and so never waits for changes.
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

/// The immutable model of a scene; frames that are being drawn share it.
struct SceneModel {
  Surface surface;
  PatchMap patches;
  std::uint64_t id = 0;  // unique in the process; branches of a scene share the model with its id
  std::string name;      // "creature", "obj", ...
  FurPatches fur_patches = FurPatches::overlapping;
  std::vector<ChosenTriangles> subdivisions = {};  // applied in order since the model was prepared
  std::string mesh_id = {};                        // SceneSummary::model_id
  std::shared_ptr<const SceneModel> rest = {};     // of a posed model: the model at rest, with the same vertices
};

/// The motion of an animated model, which makes its fur swing.
struct BodySwing {
  /// Returns the skin's acceleration at a vertex at a scene time in seconds, in sizes per second squared, rotated along
  /// with the skin from then to now: the form that BodyMotion (server/motion) takes. Called from several threads.
  std::function<glm::dvec3(std::uint32_t vertex, double time)> acceleration;
  double step = 1.0 / 24;  // time between known accelerations, in seconds, [1/1000, 1]
};

/// The pose of a scene at one time: its moved model, and its settings moved along. The groom stays.
struct ScenePose {
  std::shared_ptr<const SceneModel> model;  // has the triangles of the scene's model
  SceneSettings settings;
  std::optional<BodySwing> swing = {};
};

/// The parts of a scene that drawing reads.
struct SceneView {
  const SceneModel& model;
  const FieldSet& fields;
  const SceneSettings& settings;
  Revision revision;
  const RawImage* skin_texture = nullptr;  // the texture that the settings name; null for the model's own colours
  std::uint64_t copy_id = model.id;        // key under which the renderer caches the model with these fields
  const BodySwing* swing = nullptr;        // null for a still model
  bool masked = false;                     // FrameRequest::masked
};

/// Returns the range of all vertices of a model.
inline std::vector<VertexRange> full_vertex_range(std::size_t vertices) {
  return {{0, static_cast<std::uint32_t>(vertices)}};
}

/// The vertices that a scene's most recent changes touched, so that a renderer with an older snapshot copies only
/// those.
class RecentChanges {
 public:
  static constexpr std::size_t max_known = 256;

  /// Returns the number of the last change; 0 before the first.
  std::uint64_t number() const { return number_; }
  /// Returns a copy with one more change.
  RecentChanges with(std::vector<VertexRange> touched) const;
  /// Returns the vertices that the changes after a number touched, sorted and without overlaps; nothing if they are no
  /// longer known.
  std::optional<std::vector<VertexRange>> since(std::uint64_t number) const;

 private:
  std::uint64_t number_ = 0;
  std::vector<std::shared_ptr<const std::vector<VertexRange>>> known_;  // newest last
};

struct SceneSnapshot {
  std::shared_ptr<const SceneModel> model;
  std::shared_ptr<const FieldSet> fields;
  std::shared_ptr<const SceneSettings> settings;
  Revision revision = 0;
  std::uint64_t copy_id = 0;  // SceneView::copy_id if the scene is not posed
  std::shared_ptr<const RawImage> skin_texture = {};
  std::shared_ptr<const ScenePose> pose = {};
  RecentChanges changes = {};

  /// Returns a view of the scene in its pose. It is valid as long as the snapshot lives.
  SceneView view(bool masked = false) const;
  /// Returns an estimate of the snapshot's bytes without the model. The skin texture is included, even if the scene
  /// shares it.
  std::size_t bytes() const;
};

using SnapshotPtr = std::shared_ptr<const SceneSnapshot>;

/// A copy of a scene's groom at a revision, independent of what becomes of the scene.
struct GroomSource {
  std::string scene;
  std::optional<Revision> asked = {};  // the revision that was asked for
  Revision revision = 0;
  std::shared_ptr<const SceneModel> model;
  std::shared_ptr<const FieldSet> fields;
};

}  // namespace pelage
