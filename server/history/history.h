// The undo log of one scene in memory: steps, what can be undone and redone, and what it takes to go to any revision.
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

/// The settings with a command that sets one of them carried out; none for other commands. A checkpoint that names no
/// revision is put at `next`.
std::optional<SceneSettings> with_setting(SceneSettings settings, const Command& command, Revision next = 0);
/// The commands that set all of them.
std::vector<Command> commands_of(const SceneSettings& settings);

/// The word of a kind on the wire.
std::string name_of(EntryKind kind);

/// A request with an Idempotency-Key: what it was, so that its answer is given again to this request alone.
struct KeyedRequest {
  std::string path, key;
  std::string fingerprint;  // of its method, path, query and body
};

/// One accepted change, as the journal keeps it.
struct Entry {
  Revision revision = 0;
  EntryKind kind = EntryKind::command;
  std::uint64_t argument = 0;                     // steps of undo and redo, the revision that a revert goes back to
  std::string commands;                           // JSON text of the resolved commands; "" for undo, redo and revert
  FieldDelta delta;                               // between the revision before and this one
  FieldsHash fields_hash;                         // after it
  std::shared_ptr<const SceneSettings> settings;  // after it, where its commands changed any; else null
  std::vector<std::string> pictures = {};         // that its commands name; not read back
  std::string author = {};                        // as in LogEntry
  std::optional<KeyedRequest> request = {};       // that made it; not read back
};

/// Where the changes of steps are stored. Memory holds at most `bytes` of them; the oldest are evicted first, and are
/// read back from the journal when undo reaches them.
struct UndoMemory {
  std::size_t bytes = std::numeric_limits<std::size_t>::max();
  /// Reads the change that leads from one revision to a later one. Required if `bytes` has a limit.
  std::function<Result<FieldDelta>(Revision from, Revision to)> read = {};
};

/// A step of the list of commands that leads to the present.
struct ListedStep {
  Revision number = 0;            // as LogEntry::step
  Revision first = 0, last = 0;   // those of its entries; they differ where parts were joined
  Revision before = 0;            // one that has the list up to it and the same state
  std::vector<Command> commands;  // a stroke that came in parts is one whole stroke without an id
};

/// An entry of that list, with its commands still to be decoded.
struct ListedEntry {
  Revision step = 0, revision = 0, before = 0;  // as ListedStep has number, first and last, and before
  std::string commands;                         // as in Entry
  bool joins = false;                           // the entry before it
};
/// The steps of a list that begins with its last entry.
std::vector<ListedStep> steps_of(const std::vector<ListedEntry>& entries);
/// The commands of the steps.
std::vector<std::vector<Command>> commands_of(const std::vector<ListedEntry>& entries);

/// A change as clients that follow the scene are told of it; its `ops` are still to be read from its commands.
struct LoggedChange {
  ChangeEvent event;
  std::string commands;  // as in Entry
};

/// Record k describes the state at revision first + k. The commands that lead to a state form a list that shares its
/// beginning with the lists of other states, so that undo and revert never copy or re-evaluate anything.
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

  /// Returns what undoing or redoing `steps` steps changes. Refused (invalid, "/steps") if there are fewer; fails as
  /// UndoMemory::read does.
  Result<FieldDelta> undo(std::uint64_t steps) const;
  Result<FieldDelta> redo(std::uint64_t steps) const;
  /// Returns what the last step changed, with all changes that joined it. There must be a last step.
  Result<FieldDelta> last_step() const { return change(done_.back()); }
  /// Returns the bytes of memory that the steps' changes take.
  std::size_t held_bytes() const { return held_bytes_; }
  /// An estimate of all that the log takes in memory.
  std::size_t bytes() const { return held_bytes_ + record_bytes_; }

  /// Returns whether the entry can follow: the next revision, and steps and revisions that there are.
  bool accepts(const Entry& entry) const;
  /// What prepare() makes and record() takes.
  class Prepared;
  /// Entries that follow one another, the first of them accepted; an undo or redo comes alone.
  Prepared prepare(std::span<const Entry> entries) const;
  /// Reserves memory for as many more entries, so that recording them cannot fail. Nothing visible changes.
  void reserve(std::size_t entries);
  /// Takes what was just prepared, for which there is room, and cannot fail. Both a running scene and a restart come
  /// through here.
  void record(Prepared prepared) noexcept;
  void record(const Entry& entry);

  /// One line for each entry, oldest first.
  std::vector<LogEntry> log() const;
  /// At most `max` entries that come next after a revision from first_revision() on, oldest first.
  std::vector<LoggedChange> changes_after(Revision after, std::size_t max) const;
  /// The entries whose commands lead from the first groom to the present state, newest first.
  std::vector<ListedEntry> listed_entries() const;
  /// Their steps, oldest first. After an amendment each replayed step is one of them, though all are undone together.
  std::vector<ListedStep> listed_steps() const { return steps_of(listed_entries()); }
  /// The commands from the first groom to the present state, one element for each step; parts of a stroke are one whole
  /// stroke without an id.
  std::vector<std::vector<Command>> effective_log() const { return commands_of(listed_entries()); }

 private:
  struct Record {
    LogEntry line;
    std::uint64_t argument = 0;                  // as in Entry
    std::size_t undo_steps = 0, redo_steps = 0;  // once it was recorded
    std::size_t top = 0;                         // record of the last entry in the list of commands that leads here
    Revision step = 0;                           // number of the last step in that list
    std::size_t below = 0;  // do, join and replay: the top of the list before this entry; the list ends at 0
    std::shared_ptr<const SceneSettings> settings;
  };
  struct Step {
    std::string bytes;                  // encode_delta of what it changes; "" where only the journal has it
    std::size_t before = 0, after = 0;  // records that describe the states
  };

  bool is_last(EntryKind kind) const;
  Record next_record(const Entry& entry, std::size_t index, const Record& last) const;
  Result<FieldDelta> change(const Step& step) const;
  std::optional<FieldDelta> change_in_memory(const Step& step) const;
  Result<FieldDelta> change_of_last(const std::vector<Step>& steps, std::uint64_t count) const;
  void add_step(std::string bytes) noexcept;
  void join_step(std::string bytes) noexcept;
  void drop(Step& step) noexcept;
  void keep_to_budget() noexcept;
  void record_one(EntryKind kind, Record record, std::string bytes) noexcept;

  Revision first_;
  std::vector<Record> records_;
  std::vector<Step> done_, undone_;  // the last one is the next to undo or redo
  UndoMemory memory_;
  std::size_t held_bytes_ = 0;
  std::size_t record_bytes_ = 0;
  std::size_t dropped_ = 0;  // as many of the oldest steps of done_ are known to be without bytes
};

class History::Prepared {
 public:
  /// Returns the settings that hold once the entries are recorded.
  const std::shared_ptr<const SceneSettings>& settings() const { return changes_.back().record.settings; }

 private:
  friend class History;
  struct Change {
    EntryKind kind;
    Record record;
    std::string bytes;  // of the step as it will be; "" where the journal alone has it, and of undo and redo
  };
  std::vector<Change> changes_;
};

}  // namespace pelage
