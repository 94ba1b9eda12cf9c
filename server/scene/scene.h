// One scene: its model, fields and settings, and the story of a stroke. Commands run one at a time, in order; nobody
// who reads the scene waits for them.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/limits.h"
#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/command.h"
#include "protocol/commands/history.h"
#include "protocol/commands/pick.h"
#include "protocol/commands/scene.h"
#include "server/fields/field_set.h"
#include "server/history/history.h"
#include "server/history/live_stroke.h"
#include "server/patches/patches.h"
#include "server/patches/subdivide.h"
#include "server/scene/batch.h"
#include "server/scene/map_pictures.h"
#include "server/scene/scene_memory.h"
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

/// The groom of a scene at a revision of its model, which stays whatever becomes of the scene.
struct GroomSource {
  std::string scene;
  std::optional<Revision> asked = {};  // the revision that was asked for
  Revision revision = 0;
  std::shared_ptr<const SceneModel> model;
  std::shared_ptr<const FieldSet> fields;
};

/// How a model that moves has moved, which makes its fur swing.
struct BodySwing {
  /// Of the skin at a vertex at a time of the scene, sizes per second squared, turned as the skin has turned since:
  /// what BodyMotion (server/motion) wants. Called from several threads.
  std::function<glm::dvec3(std::uint32_t vertex, double time)> acceleration;
  double step = 1.0 / 24;  // seconds, [1/1000, 1], from one known acceleration to the next
};

/// What drawing needs to read, for as long as the callback of Scene::read runs.
struct SceneView {
  const SceneModel& model;
  const FieldSet& fields;
  const SceneSettings& settings;
  Revision revision;
  const RawImage* skin_texture = nullptr;              // that the settings name; null for the model's own colours
  std::uint64_t copy_id = model.id;                    // what the renderer keeps the model with these fields by
  std::shared_ptr<const SceneModel> model_owner = {};  // for those who read on when it has returned
  std::shared_ptr<const RawImage> picture_owner = {};
  const BodySwing* swing = nullptr;  // null for a model that stands still
  std::shared_ptr<const FieldSet> fields_owner = {};
  std::shared_ptr<const SceneSettings> settings_owner = {};
};

/// How a scene stands at a moment: its model elsewhere, and its settings with what stands on the model there. The groom
/// stays what it is.
struct ScenePose {
  std::shared_ptr<const SceneModel> model;  // with the triangles of the scene's
  SceneSettings settings;
  std::optional<BodySwing> swing = {};
};

/// What a scene's fields were at a revision.
struct PastFields {
  std::shared_ptr<const SceneModel> model;
  FieldSet fields;
};

class SceneCopy;

struct ExecuteOptions {
  std::optional<Revision> if_match = {};  // refused (precondition) when the scene is at another revision
  bool dry_run = false;                   // answer what it would do; nothing changes
  std::vector<GroomSource> sources = {};  // what retargets take (SceneStore::execute and amend find them)
  Cancel cancel = {};                     // evaluation ends (unavailable) once nobody waits; nothing changes
  std::string author = {};                // LogEntry::author of what is changed; a new model's log has no entry for it
  std::optional<KeyedRequest> request = {};  // kept with what is changed
};

/// What has become of a scene.
struct SceneNews {
  SceneEvent now;
  std::vector<ChangeEvent> changes;  // the next ones, in order
};

struct Undo {
  int steps = 1;
};  // [1, 1e6]; more than there are: invalid, nothing changes
struct Redo {
  int steps = 1;
};
struct Revert {
  Revision revision = 0;
};  // any earlier revision of this model
using HistoryMove = std::variant<Undo, Redo, Revert>;

class Journal;
struct MapFile;
struct StoredModel;

/// Thread-safe. Every accepted change is in the journal (and synced) before its answer is returned. What changes the
/// scene waits for the change before it; all else sees the scene as it was after the last change, and waits for none.
class Scene {
 public:
  /// A scene at its first groom, revision 0; SceneStore puts it into the journal. Of its undo steps at most
  /// `undo_bytes` stay in memory.
  Scene(std::string id, std::string name, std::shared_ptr<const SceneModel> model, FirstGroom fur, Journal& journal,
        std::size_t undo_bytes = limits::undo_bytes);

  /// Takes the place of what the constructor made: the stored first groom and every entry of the journal since. Fails
  /// (internal) when they do not fit together; the scene then stands before the first one that does not.
  /// Settings begin as `settings` say, or as a scene of this model begins.
  Status restore(const FieldDelta& first_groom, Revision first,
                 const std::shared_ptr<const SceneSettings>& settings = nullptr);

  /// A scene that could be restored in part stays as it was before the damage: it can be looked at, exported, branched
  /// and removed, and refuses changes (conflict). `why` is what its summary says from now on.
  void quarantine(const std::string& why);

  /// The story of a stroke: resolve, evaluate, journal, apply. All or nothing; a batch is one undo step. Pointers of
  /// refusals begin with "/commands/K" when there is more than one command. A change that touches nothing (no field
  /// bit, no setting) keeps the revision and makes no step.
  Result<CommandAnswer> execute(const std::vector<Command>& commands, const ExecuteOptions& options = {});
  Result<CommandAnswer> move(const HistoryMove& move, const ExecuteOptions& options = {});

  /// Puts other commands in the place of an earlier step and evaluates the steps after it anew: a revert to before the
  /// step, then an entry for each step that changes anything, all of them or none, and one undo step. Refused (invalid)
  /// with "/revision" when no step that is in effect has it, with "/commands/K" as execute does, and with "/commands"
  /// when a later step cannot be replayed. Results are those of all replayed commands.
  Result<CommandAnswer> amend(const AmendRequest& request, const ExecuteOptions& options = {});

  /// A scene of its own, in the journal too, that begins as this one is or was `at` a revision (refused, "/revision",
  /// where this model has none of that number). `copy_id` is its own for the renderer.
  Result<std::shared_ptr<Scene>> branch(const std::string& id, const std::string& name, std::optional<Revision> at,
                                        std::uint64_t copy_id, const std::optional<KeyedRequest>& request = {}) const;

  /// Refused (invalid, "/revision") when this model has no such revision.
  Status has_revision(Revision revision) const;
  /// Refused (invalid, with the pointer) as compare does.
  Result<PastFields> past_fields(Revision revision, const std::string& pointer = "/overlay_from") const;
  /// All that drawing reads, as it was, under a `copy_id` of its own. Reads the journal as past_fields does. Refused
  /// (invalid, "/revision") when this model has no such revision.
  Result<SceneCopy> copy_at(Revision revision, std::uint64_t copy_id) const;

  SceneSummary summary() const;
  SceneMemory memory() const noexcept;
  /// Of a revision, the present one when none is given. Refused (invalid, "/revision") when this model has no such
  /// revision.
  Result<SettingsAnswer> settings(std::optional<Revision> revision = {}) const;
  /// All entries of the journal since the model came, oldest first.
  std::vector<LogEntry> log() const;
  /// The commands that lead from the first groom to where the scene is now, resolved; one element for each undo step.
  std::vector<std::vector<Command>> effective_log() const;
  /// The same, carried to another model (carried_command). The message of a refusal gives the number of its step,
  /// from 1.
  Result<std::vector<std::vector<Command>>> effective_log_for(const SceneModel& other) const;
  std::shared_ptr<const SceneModel> model() const;
  /// What a retarget takes from this scene: at the present revision or an earlier one of this model, else refused
  /// (invalid, "/revision").
  Result<GroomSource> groom(std::optional<Revision> revision) const;
  Result<PickAnswer> pick(const PickRequest& wanted) const;
  /// A field through the model's texture coordinates. Refused as make_map_file.
  Result<MapFile> draw_map(const MapRequest& request) const;
  /// Refused (invalid, "/from" or "/to") for revisions that this model does not have.
  Result<Comparison> compare(Revision from, Revision to) const;

  /// What `use` sees does not change while it runs.
  void read(const std::function<void(const SceneView&)>& use) const;
  /// As read, and hands over the vertex ranges that changed since the last call (everything after a new model, and
  /// after a call whose `use` has thrown).
  void read_for_drawing(const std::function<void(const SceneView&, const std::vector<VertexRange>&)>& use);

  /// Lets whoever draws the present see the scene so until the next call, and at rest for none; settings that are set
  /// meanwhile are not seen. No part of the groom: not in the journal, and revisions stay. The pose has the model's
  /// triangles.
  void pose(std::optional<ScenePose> pose);

  /// A new model starts an empty log at the next revision. `stored` is what the journal keeps of it.
  Result<SceneSummary> replace_model(const std::shared_ptr<const SceneModel>& model, FirstGroom fur, StoredModel stored,
                                     const ExecuteOptions& options = {});

  /// Splits triangles of the model, whose fields, roots and settings stay; checkpoints are dropped. An empty log starts
  /// at the next revision, unless no triangle was chosen: then nothing changes. `id` is the new model's. Refused
  /// (invalid, "/levels") beyond the limit of triangles.
  Result<SceneSummary> subdivide(const Subdivide& how, std::uint64_t id, const ExecuteOptions& options = {});

  /// Takes the scene out of the journal. Whoever still holds it gets not_found for every change.
  Status remove();

  /// Waits until the revision is above `after`, the scene is removed, `or_else` holds or `seconds` have gone by; the
  /// revision then. Whoever makes `or_else` true calls wake(); it is asked under the scene's lock.
  Revision wait_newer(Revision after, double seconds, const std::function<bool()>& or_else = {}) const;
  void wake() const;
  /// The present, and at most 256 changes that came next after a revision; none where this model has no such revision.
  SceneNews news(std::optional<Revision> after) const;
  Revision revision() const;
  /// A scene that has been removed is at no revision.
  bool is_at(Revision revision) const { return !removed() && newest_ == revision; }
  bool removed() const { return removed_; }
  const std::string& id() const;

 private:
  /// Commands as they are evaluated and as they are logged: with pixels resolved, and parts of a stroke joined.
  struct Plan {
    std::vector<Step> whole;
    std::vector<Command> logged;
    bool joins = false;
  };

  /// What the names and revisions in commands refer to.
  struct Past {
    const SceneSettings& settings;
    const FieldSet& fields;
    std::function<Result<FieldSet>(Revision)> fields_at;
    const ExecuteOptions& options;
    BatchPictures& pictures;
    double& visits;  // of vertices, by pixels of the commands so far
  };
  /// Steps that have been evaluated but are not in the journal yet.
  struct Replay {
    FieldSet fields;  // after them
    std::shared_ptr<const SceneSettings> settings;
    std::vector<Entry> entries;
    std::vector<CommandResult> results;
  };

  /// That the settings name; none for the model's own colours.
  struct LaidPicture {
    std::shared_ptr<const RawImage> image = {};
    std::string name = {};
  };

  /// What readers see. None of it changes.
  struct Snapshot {
    std::shared_ptr<const SceneModel> model;
    std::uint64_t copy_id;
    std::shared_ptr<const FieldSet> fields;
    std::shared_ptr<const SceneSettings> settings;
    Revision revision;
    LaidPicture picture;
    std::shared_ptr<const ScenePose> pose;

    SceneView view() const;
  };
  Snapshot snapshot() const;
  /// Refused as check_revision.
  Result<Snapshot> snapshot_with(Revision revision, const std::string& pointer) const;
  Result<std::shared_ptr<const SceneSettings>> settings_at(Revision revision) const;
  Result<FieldSet> fields_before(const Snapshot& now, Revision revision) const;
  Result<LaidPicture> picture_of(const SceneSettings& settings, const LaidPicture& present) const;

  /// What a model brings along, ready to take the place of what is there.
  struct Beginning {
    std::shared_ptr<const SceneModel> model;
    std::shared_ptr<const FieldSet> fields;
    History history;
    LaidPicture picture;
    std::vector<VertexRange> dirty;
  };
  static Beginning beginning(std::shared_ptr<const SceneModel> model, FieldSet fields, History history,
                             LaidPicture picture);

  // All of these need `changing_`.
  Result<Plan> plan(const std::vector<Command>& commands, const ExecuteOptions& options) const;
  Result<Step> prepare(const Command& command, const std::vector<Command>& before, const Past& past) const;
  Status commit(std::span<const Entry> entries, FieldSet fields, LiveStroke live);
  Result<Replay> begin_replay(Revision before) const;
  /// `number` as LogEntry::step.
  Status replay_step(Replay& replay, Revision number, const std::vector<Command>& commands,
                     const ExecuteOptions& options) const;
  Result<Entry> entry_of(const HistoryMove& move) const;
  Result<FieldSet> fields_at(Revision revision) const;
  void begin_anew(Beginning& beginning) noexcept;
  Result<Step> with_rest(Command command, const Past& past) const;
  Status check_names(const Command& command, const std::vector<Command>& before, SceneSettings settings) const;
  CommandAnswer answer(std::vector<CommandResult> results) const;

  // These need `changing_` or `mutex_`.
  Status gone() const;
  Status admit(const ExecuteOptions& options) const;
  Snapshot present() const;
  Status check_revision(Revision revision, std::string pointer = "/revision") const;
  void announce() noexcept;  // needs both
  History new_history(Revision first, SceneSettings settings) const;

  const std::string id_, name_;
  Journal& journal_;
  const std::size_t undo_bytes_;
  // Whoever changes the scene holds `changing_` from the first look to the end, and `mutex_` to put in place what is
  // ready and on disk. Whoever reads it holds `mutex_` for a look or a copy, and never for work.
  std::mutex changing_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::shared_ptr<const SceneModel> model_;
  std::uint64_t copy_id_;
  std::shared_ptr<const FieldSet> fields_;
  History history_;
  LiveStroke live_;
  LaidPicture picture_;
  std::shared_ptr<const ScenePose> pose_;
  std::vector<VertexRange> dirty_;   // since the last frame; readers take it
  std::atomic<Revision> newest_{0};  // history_.revision(), without the lock
  std::atomic<bool> removed_{false};
  std::string damage_;  // of its journal; "" for none
};

// A scene at a revision, for as long as anybody wants it.

/// What a SceneView shows. None of it changes; it is shared with the scene.
class SceneCopy {
 public:
  /// Of a view with all owners.
  explicit SceneCopy(const SceneView& scene)
      : model_(scene.model_owner),
        picture_(scene.picture_owner),
        fields_(scene.fields_owner),
        settings_(scene.settings_owner),
        revision_(scene.revision),
        copy_id_(scene.copy_id) {}
  SceneCopy(PastFields past, std::shared_ptr<const SceneSettings> settings, std::shared_ptr<const RawImage> picture,
            Revision revision, std::uint64_t copy_id)
      : model_(std::move(past.model)),
        picture_(std::move(picture)),
        fields_(std::make_shared<const FieldSet>(std::move(past.fields))),
        settings_(std::move(settings)),
        revision_(revision),
        copy_id_(copy_id) {}

  /// For as long as the copy lives.
  SceneView view() const {
    return {*model_, *fields_, *settings_, revision_, picture_.get(), copy_id_,
            model_,  picture_, nullptr,    fields_,   settings_};
  }
  /// An estimate of what it takes beside the model. A picture that the scene has too counts here as well.
  std::size_t bytes() const {
    return sizeof(SceneCopy) + fields_->bytes() + (picture_ ? picture_->rgba.capacity() : 0);
  }

 private:
  std::shared_ptr<const SceneModel> model_;
  std::shared_ptr<const RawImage> picture_;
  std::shared_ptr<const FieldSet> fields_;
  std::shared_ptr<const SceneSettings> settings_;
  Revision revision_;
  std::uint64_t copy_id_;
};

}  // namespace pelage
