// One scene: its model, fields, settings and undo history, and the commands that change them. Changes run one at a
// time, in order; readers get immutable snapshots.
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
#include "server/scene/batch.h"
#include "server/scene/change_turns.h"
#include "server/scene/map_pictures.h"
#include "server/scene/scene_memory.h"
#include "server/scene/snapshot.h"

namespace pelage {

struct ExecuteOptions {
  std::optional<Revision> if_match = {};     // refused (precondition) if the scene is at another revision
  bool dry_run = false;                      // returns the answer without changing anything
  std::vector<GroomSource> sources = {};     // sources of retargets; SceneStore::execute and amend fill them in
  Cancel cancel = {};                        // cancels the evaluation (unavailable); nothing changes then
  std::string author = {};                   // LogEntry::author of the change; a new model's log has no entry for it
  std::optional<KeyedRequest> request = {};  // stored with the change, to recognize a repeated request
};

/// The current state of a scene, and changes since a revision.
struct SceneNews {
  SceneEvent now;
  std::vector<ChangeEvent> changes;  // the changes that follow the revision asked for, in order
};

struct Undo {
  int steps = 1;
};  // [1, 1e6]; refused (invalid) if there are fewer; nothing changes then
struct Redo {
  int steps = 1;
};
struct Revert {
  Revision revision = 0;
};  // any revision of this model up to the present
using HistoryMove = std::variant<Undo, Redo, Revert>;

class Journal;
struct MapFile;
struct StoredModel;

/// Thread-safe. Every accepted change is in the journal (and synced) before its answer is returned. Functions that
/// change the scene wait for earlier changes (ChangeTurns) and fail as that does. All others see the scene as of its
/// last change and do not wait.
class Scene {
 public:
  /// Makes a scene with its first groom at revision 0; SceneStore puts it into the journal. At most `undo_bytes` of its
  /// undo steps stay in memory. Null `settings` stand for the model's first_settings.
  Scene(std::string id, std::string name, std::shared_ptr<const SceneModel> model, FirstGroom fur, Journal& journal,
        std::size_t undo_bytes = limits::undo_bytes, const SceneSettings* settings = nullptr);

  /// Restores the scene from the journal: the stored first groom, then every entry since. It replaces the state that
  /// the constructor made. Fails (internal) if an entry does not fit; the scene then has the state before that entry.
  /// Null `settings` stand for the model's first_settings.
  Status restore(const FieldDelta& first_groom, Revision first,
                 const std::shared_ptr<const SceneSettings>& settings = nullptr);

  /// Marks a scene as damaged. Its intact part can be viewed, exported, branched and removed, but changes are refused
  /// (conflict). `why` appears in its summary from then on.
  void quarantine(const std::string& why);

  /// Executes commands: resolve, evaluate, journal, apply. All of them take effect or none; a batch is one undo step.
  /// Pointers of errors begin with "/commands/K" if there is more than one command. A batch that changes no bit of a
  /// field and no setting keeps the revision and makes no step.
  Result<CommandAnswer> execute(const std::vector<Command>& commands, const ExecuteOptions& options = {});
  Result<CommandAnswer> move(const HistoryMove& move, const ExecuteOptions& options = {});

  /// Replaces the commands of an earlier step and evaluates the steps after it again. The log gets a revert to before
  /// the step, then an entry for each step that changes anything; all of that takes effect or none, and is one undo
  /// step. Refuses (invalid) with "/revision" if no step in effect has that revision, with "/commands/K" as execute
  /// does, and with "/commands" if a later step cannot be replayed. The results are those of all replayed commands.
  Result<CommandAnswer> amend(const AmendRequest& request, const ExecuteOptions& options = {});

  /// Makes an independent scene, also in the journal, that begins with this one's state, as of revision `at` if given.
  /// Refuses (invalid, "/revision") a revision that this model does not have. `copy_id` is the new scene's
  /// SceneView::copy_id.
  Result<std::shared_ptr<Scene>> branch(const std::string& id, const std::string& name, std::optional<Revision> at,
                                        std::uint64_t copy_id, const std::optional<KeyedRequest>& request = {}) const;

  /// Refuses (invalid, "/revision") a revision that this model does not have.
  Status has_revision(Revision revision) const;
  /// Returns the present state; the scene may change meanwhile.
  SnapshotPtr snapshot() const;
  /// Returns the state at a revision, for an earlier one without copy_id and pose. It reads the journal. Refuses
  /// (invalid, with the pointer) a revision that this model does not have.
  Result<SceneSnapshot> snapshot_at(Revision revision, const std::string& pointer = "/revision") const;

  SceneSummary summary() const;
  SceneMemory memory() const noexcept;
  /// Returns the settings at a revision, by default the present one. Refuses (invalid, "/revision") a revision that
  /// this model does not have.
  Result<SettingsAnswer> settings(std::optional<Revision> revision = {}) const;
  /// Returns all log entries since the model was set, oldest first.
  std::vector<LogEntry> log() const;
  /// Returns the resolved commands that lead from the first groom to the present state, as History::effective_log.
  std::vector<std::vector<Command>> effective_log() const;
  /// Returns effective_log() converted for another model (transferred_command). The message of an error gives the
  /// number of the step, from 1.
  Result<std::vector<std::vector<Command>>> effective_log_for(const SceneModel& other) const;
  std::shared_ptr<const SceneModel> model() const;
  /// Returns the groom that a retarget takes from this scene, at the given revision or the present one. Refuses
  /// (invalid, "/revision") a revision that this model does not have.
  Result<GroomSource> groom(std::optional<Revision> revision) const;
  /// Picks as pelage::pick does. The fields are those of the named coat; "" stands for the first visible one.
  Result<PickAnswer> pick(const PickRequest& wanted, const std::string& coat = "") const;
  /// Draws a field as a map through the model's texture coordinates. Fails as make_map_file does.
  Result<MapFile> draw_map(const MapRequest& request) const;
  /// Compares the fields at two revisions. Refuses (invalid, "/from" or "/to") revisions that this model does not have.
  Result<Comparison> compare(Revision from, Revision to) const;

  /// Sets the pose in which the present scene is drawn until the next call; nothing stands for the rest pose. Settings
  /// that change meanwhile stay invisible. The pose is not part of the groom: it is not in the journal, and the
  /// revision does not change. It must have the triangles of the scene's model. The caller must be the only one that
  /// changes the scene.
  void pose(std::optional<ScenePose> pose);

  /// Sets a new model, which starts an empty log at the next revision. `stored` is the journal's form of the model;
  /// `ground` makes the ground visible at first.
  Result<SceneSummary> replace_model(const std::shared_ptr<const SceneModel>& model, FirstGroom fur, StoredModel stored,
                                     bool ground = false, const ExecuteOptions& options = {});

  /// Sets a new version of the model and transfers the groom to it (transferred_groom). An empty log starts at the next
  /// revision; `stored` must say that the groom is older than the log (StoredModel::subdivisions). The summary reports
  /// the transfer.
  Result<SceneSummary> transfer_groom_to(const std::shared_ptr<const SceneModel>& model, StoredModel stored,
                                         const ExecuteOptions& options = {});

  /// Subdivides triangles of the model. Fields, roots and settings stay; checkpoints are dropped. An empty log starts
  /// at the next revision, unless no triangle was chosen: then nothing changes. `id` is the new model's. Refuses
  /// (invalid, "/levels") a result above the limit of triangles.
  Result<SceneSummary> subdivide(const Subdivide& how, std::uint64_t id, const ExecuteOptions& options = {});

  /// Rotates the model to other up and front axes, with its fur and what stands on it; checkpoints are dropped. An
  /// empty log starts at the next revision, unless the axes stay the same: then nothing changes. `id` is the new
  /// model's. Refuses (invalid, "/front") two axes on one line.
  Result<SceneSummary> turn(const TurnModel& how, std::uint64_t id, const ExecuteOptions& options = {});

  /// Renames the scene; the revision stays.
  Status rename(const std::string& name);

  /// Removes the scene from the journal, without waiting for a change that is being evaluated. That change and later
  /// ones by those who still hold the scene fail (not_found).
  Status remove();

  /// Waits until the revision is above `after`, the scene is removed, `or_else` returns true or `seconds` have passed,
  /// and returns the revision then. `or_else` is called with the scene's lock held; whoever makes it true must call
  /// wake().
  Revision wait_newer(Revision after, double seconds, const std::function<bool()>& or_else = {}) const;
  void wake() const;
  /// Returns the present state and at most 256 changes that follow a revision; no changes if this model does not have
  /// that revision.
  SceneNews news(std::optional<Revision> after) const;
  Revision revision() const;
  /// Returns whether the scene is at this revision; always false for a removed scene.
  bool is_at(Revision revision) const { return !removed() && newest_ == revision; }
  bool removed() const { return removed_; }
  const std::string& id() const;

 private:
  /// Commands as they are evaluated and as they are logged. Positions under pixels are resolved in both; the evaluated
  /// ones hold the whole stroke so far.
  struct Plan {
    std::vector<Step> merged;
    std::vector<Command> to_log;
    bool joins = false;
  };

  /// The state that names and revisions in commands refer to.
  struct Past {
    const SceneSettings& settings;
    const FieldSet& fields;
    std::function<Result<FieldSet>(Revision)> fields_at;
    const ExecuteOptions& options;
    BatchPictures& pictures;
    double& visits;  // vertices visited so far to resolve the pixels of the commands, for the cost limit
  };
  /// Steps that are evaluated but not in the journal yet.
  struct Replay {
    FieldSet fields;  // after all steps
    std::shared_ptr<const SceneSettings> settings;
    std::vector<Entry> entries;
    std::vector<CommandResult> results;
  };

  Result<FieldSet> fields_before(const SceneSnapshot& now, Revision revision) const;
  Result<std::shared_ptr<const RawImage>> skin_texture_of(const SceneSettings& settings,
                                                          const SceneSnapshot* present) const;
  /// Returns the snapshot with which a scene begins: a model, its fields, a log, and the texture that its settings
  /// name.
  SnapshotPtr first_snapshot(std::shared_ptr<const SceneModel> model, FieldSet fields, const History& history,
                             std::shared_ptr<const RawImage> skin_texture) const;

  // The caller of these must hold a turn (ChangeTurns).
  Result<Plan> plan(const std::vector<Command>& commands, const ExecuteOptions& options) const;
  Result<Step> prepare(const Command& command, const std::vector<Command>& before, const Past& past) const;
  Status commit(std::span<const Entry> entries, FieldSet fields, LiveStroke live);
  Result<Replay> begin_replay(Revision before) const;
  /// `number` is as in LogEntry::step.
  Status replay_step(Replay& replay, Revision number, const std::vector<Command>& commands,
                     const ExecuteOptions& options) const;
  Result<Entry> entry_of(const HistoryMove& move) const;
  Result<FieldSet> fields_at(Revision revision) const;
  Status replace_state(SnapshotPtr& snapshot, History& history, const std::function<Status()>& write);
  Result<SceneSummary> restart_with(const StoredScene& stored, const std::shared_ptr<const SceneModel>& model,
                                    FieldSet fields, std::shared_ptr<const RawImage> skin_texture,
                                    Status (Journal::*write)(const StoredScene&));
  Result<Step> with_baseline(Command command, const Past& past) const;
  Status check_names(const Command& command, const std::vector<Command>& before, SceneSettings settings) const;
  CommandAnswer answer(std::vector<CommandResult> results) const;

  /// Takes a turn. Refuses as ChangeTurns::take does, and if the scene is removed, quarantined, or at another revision
  /// than asked for.
  Result<ChangeTurns::Turn> begin_change(const ExecuteOptions& options);
  /// Calls `write`, which puts a change into the journal, and then `publish` under the lock; `publish` cannot fail.
  /// Calls neither if the scene was removed meanwhile.
  Status take_over(const std::function<Status()>& write, const std::function<void()>& publish);

  Status gone() const;
  // The caller of these must hold a turn or `mutex_`.
  Status check_revision(Revision revision, const std::string& pointer = "/revision") const;
  void publish_revision() noexcept;  // the caller must hold `mutex_`
  History new_history(Revision first, SceneSettings settings) const;

  const std::string id_;
  std::string name_;  // written only with a turn and `mutex_` held
  Journal& journal_;
  const std::size_t undo_bytes_;
  // A change holds a turn from its first read to its end, and `writing_` while the journal and then the scene take over
  // the finished change. `mutex_` is held only to read or swap members, never during work.
  ChangeTurns turns_;
  std::mutex writing_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  SnapshotPtr present_;
  History history_;
  LiveStroke live_;
  std::atomic<Revision> newest_{0};  // revision of present_, readable without the lock
  std::atomic<bool> removed_{false};
  std::string damage_;  // why the scene is quarantined; "" if it is intact
};

}  // namespace pelage
