// One scene: its model, fields and settings, and the story of a stroke. Commands run one at a time, in order; whoever
// reads the scene reads a snapshot.
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
/// scene waits for the changes before it (ChangeTurns) and fails as that does; all else sees the scene as it was after
/// the last change, and waits for none.
class Scene {
 public:
  /// A scene at its first groom, revision 0; SceneStore puts it into the journal. Of its undo steps at most
  /// `undo_bytes` stay in memory. Without `settings` they are those of the model (first_settings).
  Scene(std::string id, std::string name, std::shared_ptr<const SceneModel> model, FirstGroom fur, Journal& journal,
        std::size_t undo_bytes = limits::undo_bytes, const SceneSettings* settings = nullptr);

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
  /// The scene as it is, which others may change meanwhile.
  SnapshotPtr snapshot() const;
  /// The scene as it was at a revision: of an earlier one without a copy_id, and not posed. Reads the journal. Refused
  /// (invalid, with the pointer) when this model has no such revision.
  Result<SceneSnapshot> snapshot_at(Revision revision, const std::string& pointer = "/revision") const;

  SceneSummary summary() const;
  SceneMemory memory() const noexcept;
  /// Returns the settings at a revision, the present one when none is given. Refused (invalid, "/revision") when this
  /// model has no such revision.
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
  /// Values of fields are those of the named coat; "" for the first that is seen.
  Result<PickAnswer> pick(const PickRequest& wanted, const std::string& coat = "") const;
  /// Draws a field as a map through the model's texture coordinates. Refused as make_map_file.
  Result<MapFile> draw_map(const MapRequest& request) const;
  /// Refused (invalid, "/from" or "/to") for revisions that this model does not have.
  Result<Comparison> compare(Revision from, Revision to) const;

  /// Sets the pose in which the present scene is drawn until the next call; none stands for rest. Settings that are set
  /// meanwhile are not visible. The pose is no part of the groom: it is not in the journal, and revisions stay. It has
  /// the model's triangles. Only for a caller that alone changes the scene.
  void pose(std::optional<ScenePose> pose);

  /// Gives the scene a new model, which starts an empty log at the next revision. `stored` is what the journal keeps of
  /// the model. `ground`: whether it is visible at first.
  Result<SceneSummary> replace_model(const std::shared_ptr<const SceneModel>& model, FirstGroom fur, StoredModel stored,
                                     bool ground = false, const ExecuteOptions& options = {});

  /// Gives the scene a new version of its model, with its groom (carried_groom), which `stored` says is older than the
  /// log. An empty log starts at the next revision. The summary says how the groom went over.
  Result<SceneSummary> carry_to(const std::shared_ptr<const SceneModel>& model, StoredModel stored,
                                const ExecuteOptions& options = {});

  /// Splits triangles of the model, whose fields, roots and settings stay; checkpoints are dropped. An empty log starts
  /// at the next revision, unless no triangle was chosen: then nothing changes. `id` is the new model's. Refused
  /// (invalid, "/levels") beyond the limit of triangles.
  Result<SceneSummary> subdivide(const Subdivide& how, std::uint64_t id, const ExecuteOptions& options = {});

  /// Turns the model to stand another way, with its fur and what stands on it; checkpoints are dropped. An empty log
  /// starts at the next revision, unless it stands that way already: then nothing changes. `id` is the new model's.
  /// Refused (invalid, "/front") where both axes lie on one line.
  Result<SceneSummary> turn(const TurnModel& how, std::uint64_t id, const ExecuteOptions& options = {});

  /// Gives the scene another name, at its revision.
  Status rename(const std::string& name);

  /// Takes the scene out of the journal. Whoever still holds it gets not_found for every change.
  Status remove();

  /// Waits until the revision is above `after`, the scene is removed, `or_else` holds or `seconds` have gone by; the
  /// revision then. Whoever makes `or_else` true calls wake(); it is asked under the scene's lock.
  Revision wait_newer(Revision after, double seconds, const std::function<bool()>& or_else = {}) const;
  void wake() const;
  /// The present, and at most 256 changes that came next after a revision; none where this model has no such revision.
  SceneNews news(std::optional<Revision> after) const;
  Revision revision() const;
  /// Returns whether the scene is at this revision; a scene that has been removed is at none.
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

  Result<FieldSet> fields_before(const SceneSnapshot& now, Revision revision) const;
  Result<std::shared_ptr<const RawImage>> skin_texture_of(const SceneSettings& settings,
                                                          const SceneSnapshot* present) const;
  /// The scene as it begins with a model and a log, and the texture that its settings name.
  SnapshotPtr beginning(std::shared_ptr<const SceneModel> model, FieldSet fields, const History& history,
                        std::shared_ptr<const RawImage> skin_texture) const;

  // All of these need a turn.
  Result<Plan> plan(const std::vector<Command>& commands, const ExecuteOptions& options) const;
  Result<Step> prepare(const Command& command, const std::vector<Command>& before, const Past& past) const;
  Status commit(std::span<const Entry> entries, FieldSet fields, LiveStroke live);
  Result<Replay> begin_replay(Revision before) const;
  /// `number` as LogEntry::step.
  Status replay_step(Replay& replay, Revision number, const std::vector<Command>& commands,
                     const ExecuteOptions& options) const;
  Result<Entry> entry_of(const HistoryMove& move) const;
  Result<FieldSet> fields_at(Revision revision) const;
  Status begin_anew(SnapshotPtr& snapshot, History& history, const std::function<Status()>& write);
  Result<SceneSummary> begin_with(const StoredScene& stored, const std::shared_ptr<const SceneModel>& model,
                                  FieldSet fields, std::shared_ptr<const RawImage> skin_texture,
                                  Status (Journal::*write)(const StoredScene&));
  Result<Step> with_baseline(Command command, const Past& past) const;
  Status check_names(const Command& command, const std::vector<Command>& before, SceneSettings settings) const;
  CommandAnswer answer(std::vector<CommandResult> results) const;

  /// A turn. Refused as ChangeTurns::take, and where the scene cannot be changed or is at another revision than asked.
  Result<ChangeTurns::Turn> begin_change(const ExecuteOptions& options);
  /// Calls `write`, which puts a change into the journal, and then `publish` under the lock, which cannot fail. Neither
  /// where the scene was removed meanwhile.
  Status take_over(const std::function<Status()>& write, const std::function<void()>& publish);

  Status gone() const;
  // These need a turn or `mutex_`.
  Status check_revision(Revision revision, const std::string& pointer = "/revision") const;
  void announce() noexcept;  // needs `mutex_`
  History new_history(Revision first, SceneSettings settings) const;

  const std::string id_;
  std::string name_;  // changes under a turn and `mutex_`
  Journal& journal_;
  const std::size_t undo_bytes_;
  // Whoever changes the scene takes a turn from the first look to the end, and holds `writing_` while the journal and
  // the scene get what is ready. `mutex_` is held for a look or a swap, and never for work.
  ChangeTurns turns_;
  std::mutex writing_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  SnapshotPtr present_;
  History history_;
  LiveStroke live_;
  std::atomic<Revision> newest_{0};  // that of the present, without the lock
  std::atomic<bool> removed_{false};
  std::string damage_;  // of its journal; "" for none
};

}  // namespace pelage
