// The log of one scene in memory: its entries, the steps that can be undone and redone, and the changes that lead to
// any revision.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/command.h"
#include "protocol/commands/settings.h"
#include "server/fields/field_delta.h"

namespace pelage {

/// Returns the settings after a command that changes one of them; nothing for other commands. A checkpoint without a
/// revision gets `next`.
std::optional<SceneSettings> with_setting(SceneSettings settings, const Command& command, Revision next = 0);
/// Returns commands that set all of the settings.
std::vector<Command> commands_of(const SceneSettings& settings);

/// Returns the name of a kind in JSON.
std::string name_of(EntryKind kind);

/// A request with an Idempotency-Key. The fingerprint makes sure that the stored answer is repeated only for the same
/// request.
struct KeyedRequest {
  std::string path, key;
  std::string fingerprint;  // hash of its method, path, query and body
};

/// One accepted change, as stored in the journal.
struct Entry {
  Revision revision = 0;
  EntryKind kind = EntryKind::command;
  std::uint64_t argument = 0;                     // steps of an undo or redo; target of a revert; step of a replay
  std::string commands;                           // JSON text of the resolved commands; "" for undo, redo and revert
  FieldDelta delta;                               // from the previous revision to this one
  FieldsHash fields_hash;                         // after it
  std::shared_ptr<const SceneSettings> settings;  // after the change; null if its commands changed no setting
  std::vector<std::string> pictures = {};         // pictures that its commands name; not read back
  std::string author = {};                        // as in LogEntry
  std::optional<KeyedRequest> request = {};       // the request that made the change; not read back
};

/// Memory budget for the changes of steps. At most `bytes` of them stay in memory; the oldest are evicted first and are
/// read back from the journal when an undo needs them.
struct UndoMemory {
  std::size_t bytes = std::numeric_limits<std::size_t>::max();
  /// Reads the change from one revision to a later one. Required if `bytes` is a limit.
  std::function<Result<FieldDelta>(Revision from, Revision to)> read = {};
};

/// A step in effect: one of those whose commands lead to the present state.
struct ListedStep {
  Revision number = 0;            // as LogEntry::step
  Revision first = 0, last = 0;   // revisions of its entries; they differ if parts joined it
  Revision before = 0;            // a revision with the state before this step
  std::vector<Command> commands;  // a stroke that came in parts is one whole stroke without an id
};

/// An entry in effect, with its commands not decoded yet.
struct ListedEntry {
  Revision step = 0, revision = 0, before = 0;  // as ListedStep::number, ::first and ::last, and ::before
  std::string commands;                         // as in Entry
  bool joins = false;                           // joins the entry before it
};
/// Returns the steps, oldest first, of entries given newest first.
std::vector<ListedStep> steps_of(const std::vector<ListedEntry>& entries);
/// Returns the commands of those steps.
std::vector<std::vector<Command>> commands_of(const std::vector<ListedEntry>& entries);

/// A change as reported to clients that follow the scene; event.ops is not filled in yet.
struct LoggedChange {
  ChangeEvent event;
  std::string commands;  // as in Entry
};

/// Record k describes the state at revision first + k. The commands in effect at a revision form a linked list that
/// shares its beginning with the lists of other revisions, so that undo and revert never copy or re-evaluate anything.
class History {
 public:
  /// `settings` are those of the first revision.
  explicit History(Revision first, SceneSettings settings = {}, UndoMemory memory = {});

  Revision revision() const { return first_ + records_.size() - 1; }
  Revision first_revision() const { return first_; }
  const SceneSettings& settings() const { return *records_.back().settings; }
  const std::shared_ptr<const SceneSettings>& settings_at(Revision revision) const {
    return records_[revision - first_].settings;
  }
  std::size_t undo_steps() const { return done_.size(); }
  std::size_t redo_steps() const { return undone_.size(); }

  /// Returns the change of undoing or redoing `steps` steps. Refuses (invalid, "/steps") if there are fewer; fails as
  /// UndoMemory::read does.
  Result<FieldDelta> undo(std::uint64_t steps) const;
  Result<FieldDelta> redo(std::uint64_t steps) const;
  /// Returns the change of the last step, including all changes that joined it. Requires a step to undo.
  Result<FieldDelta> last_step() const { return change(done_.back()); }
  /// Returns the bytes of memory that the encoded changes of the steps take.
  std::size_t step_bytes() const { return step_bytes_; }
  /// Returns an estimate of the memory of the whole log, in bytes.
  std::size_t bytes() const { return step_bytes_ + record_bytes_; }

  /// Returns whether the entry can follow: it has the next revision, and the steps or revision that it names exist.
  bool accepts(const Entry& entry) const;
  /// Records made by prepare() and consumed by record().
  class Prepared;
  /// Prepares consecutive entries, of which the first must be accepted. An undo or redo must come alone.
  Prepared prepare(std::span<const Entry> entries) const;
  /// Reserves memory for `entries` more, so that recording them cannot fail. Nothing visible changes.
  void reserve(std::size_t entries);
  /// Records what was prepared last, after reserve(); cannot fail. Used by a running scene and at a restart alike.
  void record(Prepared prepared) noexcept;
  void record(const Entry& entry);

  /// Returns one line for each entry, oldest first.
  std::vector<LogEntry> log() const;
  /// Returns at most `max` entries that follow a revision, oldest first. `after` is at least first_revision().
  std::vector<LoggedChange> changes_after(Revision after, std::size_t max) const;
  /// Returns the entries whose commands lead from the first groom to the present state, newest first.
  std::vector<ListedEntry> listed_entries() const;
  /// Returns their steps, oldest first. After an amendment each replayed step is listed separately, though all are
  /// undone together.
  std::vector<ListedStep> listed_steps() const { return steps_of(listed_entries()); }
  /// Returns the commands from the first groom to the present state, one element for each step. The parts of a stroke
  /// are one whole stroke without an id.
  std::vector<std::vector<Command>> effective_log() const { return commands_of(listed_entries()); }

 private:
  struct Record {
    LogEntry line;
    std::uint64_t argument = 0;                  // as in Entry
    std::size_t undo_steps = 0, redo_steps = 0;  // counts after this entry
    std::size_t top = 0;                         // index of the last entry in the list of commands in effect here
    Revision step = 0;                           // number of the last step in that list
    std::size_t below = 0;  // command, join, replay: `top` of the list before this entry; a list ends at 0
    std::shared_ptr<const SceneSettings> settings;
  };
  struct Step {
    std::string bytes;                  // encode_delta of its change; "" if only the journal has it
    std::size_t before = 0, after = 0;  // indices of the records of the states
  };

  bool is_last(EntryKind kind) const;
  Record next_record(const Entry& entry, std::size_t index, const Record& last) const;
  Result<FieldDelta> change(const Step& step) const;
  std::optional<FieldDelta> change_in_memory(const Step& step) const;
  Result<FieldDelta> change_of_last(const std::vector<Step>& steps, std::uint64_t count) const;
  void add_step(std::string bytes) noexcept;
  void join_step(std::string bytes) noexcept;
  void drop(Step& step) noexcept;
  void evict_to_budget() noexcept;
  void record_one(EntryKind kind, Record record, std::string bytes) noexcept;

  Revision first_;
  std::vector<Record> records_;
  std::vector<Step> done_, undone_;  // back() is the next to undo or redo
  UndoMemory memory_;
  std::size_t step_bytes_ = 0;
  std::size_t record_bytes_ = 0;
  std::size_t dropped_ = 0;  // this many of the oldest steps of done_ are known to have no bytes
};

class History::Prepared {
 public:
  /// Returns the settings after the entries are recorded.
  const std::shared_ptr<const SceneSettings>& settings() const { return changes_.back().record.settings; }

 private:
  friend class History;
  struct Change {
    EntryKind kind;
    Record record;
    std::string bytes;  // of the resulting step; "" if only the journal has it, and for undo and redo
  };
  std::vector<Change> changes_;
};

}  // namespace pelage
