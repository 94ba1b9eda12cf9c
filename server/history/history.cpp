#include "server/history/history.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "protocol/json/decode.h"
#include "protocol/json/names.h"
#include "server/fields/coats.h"
#include "server/fields/edit_layers.h"
#include "server/history/codec.h"

namespace pelage {

namespace {

Status too_few(const char* verb, std::size_t available) {
  return failure(Code::invalid, std::string("there are fewer steps to ") + verb, "/steps",
                 "at most " + std::to_string(available));
}

/// Returns the commands of a log line as they can be sent again: strokes are whole, without ids and parts.
std::vector<Command> commands_to_resend(const std::string& text) {
  Result<std::vector<Command>> decoded = decode_commands(text);
  assert(decoded.ok());  // encode() wrote the text
  if (!decoded) return {};
  for (Command& command : *decoded) {
    if (Stroke* stroke = stroke_of(command)) {
      stroke->id.clear();
      stroke->part = 0;
      stroke->last = true;
    }
  }
  return std::move(*decoded);
}

/// Prepends the samples of a stroke's earlier part to those of its later part.
void prepend_samples(Command& later, const Command& earlier) {
  std::vector<StrokeSample>& samples = stroke_of(later)->samples;
  const std::vector<StrokeSample>& first = stroke_of(earlier)->samples;
  samples.insert(samples.begin(), first.begin(), first.end());
}

/// Adds a checkpoint; a name that exists moves to the checkpoint's revision.
void put_checkpoint(std::vector<NamedRevision>& checkpoints, const Checkpoint& checkpoint, Revision next) {
  const Revision revision = checkpoint.revision.value_or(next);
  const auto same = std::find_if(checkpoints.begin(), checkpoints.end(),
                                 [&](const NamedRevision& other) { return other.name == checkpoint.name; });
  if (same == checkpoints.end())
    checkpoints.push_back({checkpoint.name, revision});
  else
    same->revision = revision;
}

/// Applies a setting. A setting without an operator() here does not compile.
struct Set {
  SceneSettings& settings;
  Revision next;

  void operator()(const SetCoat& c) const { settings.coats = with_change(settings.coats, c); }
  void operator()(const SetCoats& c) const {
    std::vector<NamedCoat> after = with_change(settings.coats, c);
    settings.layers = with_coats(settings.layers, settings.coats, after);
    settings.coats = std::move(after);
  }
  void operator()(const SetLook& c) const { settings.look = c.look; }
  void operator()(const SetLights& c) const { settings.lights = c.lights; }
  void operator()(const SetEnvironment& c) const { settings.environment = c.environment; }
  void operator()(const SetGround& c) const { settings.ground = c.ground; }
  void operator()(const SetWind& c) const { settings.wind = c.wind; }
  void operator()(const SetEyes& c) const { settings.eyes = c.eyes; }
  void operator()(const SetCurves& c) const { settings.curves = c.groups; }
  void operator()(const SetSkin& c) const { settings.skin = c.regions; }
  void operator()(const SetSkinTexture& c) const { settings.skin_texture = c.picture; }
  void operator()(const SetBlowers& c) const { settings.blowers = c.blowers; }
  void operator()(const SetAttractors& c) const { settings.attractors = c.attractors; }
  void operator()(const SetSymmetry& c) const { settings.symmetry = c.symmetry; }
  void operator()(const ChangeEditLayer& c) const { settings.layers = with_change(settings.layers, c); }
  void operator()(const Checkpoint& c) const { put_checkpoint(settings.checkpoints, c, next); }
};

}  // namespace

std::optional<SceneSettings> with_setting(SceneSettings settings, const Command& command, Revision next) {
  const auto apply = [&]<class C>(const C& one) {
    if constexpr (SettingCommand<C>) Set{settings, next}(one);
    return SettingCommand<C>;
  };
  return std::visit(apply, command) ? std::optional(std::move(settings)) : std::nullopt;
}

namespace {

SetCoats command_of(const std::vector<NamedCoat>& coats) {
  SetCoats command;
  for (const NamedCoat& coat : coats)
    command.coats.push_back({.name = coat.name, .id = coat.id, .muted = coat.muted, .coat = coat.coat});
  return command;
}

}  // namespace

std::vector<Command> commands_of(const SceneSettings& settings) {
  std::vector<Command> commands{command_of(settings.coats),    SetLook{settings.look},
                                SetLights{settings.lights},    SetEnvironment{settings.environment},
                                SetGround{settings.ground},    SetWind{settings.wind},
                                SetEyes{settings.eyes},        SetCurves{settings.curves},
                                SetSkin{settings.skin},        SetSkinTexture{settings.skin_texture},
                                SetBlowers{settings.blowers},  SetAttractors{settings.attractors},
                                SetSymmetry{settings.symmetry}};
  for (const NamedRevision& named : settings.checkpoints) commands.push_back(Checkpoint{named.name, named.revision});
  for (const EditLayer& layer : settings.layers)
    commands.push_back(
        ChangeEditLayer{.name = layer.name, .weight = layer.weight, .muted = layer.muted, .coat = layer.coat});
  return commands;
}

std::string name_of(EntryKind kind) { return json_names::word_of(json_names::entry_kinds, kind); }

namespace {

/// Estimates the bytes of a record, including settings that no other record shares (else null). Curves are by far the
/// largest part of settings.
std::size_t bytes_of(const LogEntry& line, const SceneSettings* settings) noexcept {
  std::size_t bytes = 160 + line.commands.capacity() + line.author.capacity();
  if (settings == nullptr) return bytes;
  bytes += sizeof(SceneSettings);
  for (const CurveGroup& group : settings->curves) {
    for (const GuideCurve& curve : group.curves) bytes += sizeof(GuideCurve) + curve.size() * sizeof(glm::dvec3);
  }
  return bytes;
}

}  // namespace

History::History(Revision first, SceneSettings settings, UndoMemory memory)
    : first_(first), records_(1), memory_(std::move(memory)) {
  records_[0].settings = std::make_shared<const SceneSettings>(std::move(settings));
}

// Also correct for a step that parts joined after other entries were made and undone in between: their bits flip twice.
Result<FieldDelta> History::change(const Step& step) const {
  if (step.bytes.empty()) return memory_.read(first_ + step.before, first_ + step.after);
  return decode_delta(std::as_bytes(std::span(step.bytes)));
}

Result<FieldDelta> History::change_of_last(const std::vector<Step>& steps, std::uint64_t count) const {
  FieldDelta total;
  for (std::size_t i = 0; i < count; ++i) {
    const Result<FieldDelta> one = change(steps[steps.size() - 1 - i]);
    if (!one) return one.status();
    total = compose(total, *one);
  }
  return total;
}

Result<FieldDelta> History::undo(std::uint64_t steps) const {
  if (steps > done_.size()) return too_few("undo", done_.size());
  return change_of_last(done_, steps);
}

Result<FieldDelta> History::redo(std::uint64_t steps) const {
  if (steps > undone_.size()) return too_few("redo", undone_.size());
  return change_of_last(undone_, steps);
}

void History::drop(Step& step) noexcept {
  step_bytes_ -= step.bytes.size();
  step.bytes = {};
}

/// Evicts the changes of the oldest undo steps first, then those of the redo steps that are redone last.
void History::evict_to_budget() noexcept {
  dropped_ = std::min(dropped_, done_.size());
  for (; step_bytes_ > memory_.bytes && dropped_ < done_.size(); ++dropped_) drop(done_[dropped_]);
  for (std::size_t i = 0; step_bytes_ > memory_.bytes; ++i) drop(undone_[i]);
}

bool History::is_last(EntryKind kind) const { return records_.back().line.kind == name_of(kind); }

bool History::accepts(const Entry& entry) const {
  if (entry.revision != revision() + 1) return false;
  switch (entry.kind) {
    case EntryKind::command: return true;
    case EntryKind::join: return !done_.empty();
    case EntryKind::replay: return is_last(EntryKind::revert) || is_last(EntryKind::replay);
    case EntryKind::undo: return entry.argument <= done_.size();
    case EntryKind::redo: return entry.argument <= undone_.size();
    case EntryKind::revert: return entry.argument >= first_ && entry.argument <= revision();
  }
  return false;
}

/// Reserves room for `more` elements, at least doubling, so that a log that grows entry by entry is rarely copied.
template <class T>
static void reserve_more(std::vector<T>& list, std::size_t more) {
  if (list.capacity() - list.size() < more) list.reserve(std::max(2 * list.size(), list.size() + more));
}

void History::reserve(std::size_t entries) {
  reserve_more(records_, entries);
  reserve_more(done_, std::max(entries, undone_.size()));
  reserve_more(undone_, done_.size());
}

static LogEntry line_of(const Entry& entry) {
  return {.revision = entry.revision,
          .kind = name_of(entry.kind),
          .commands = entry.commands,
          .touched = entry.delta.vertices().size(),
          .author = entry.author};
}

/// Returns the number of the step that an entry makes or joins; `last` is the number of the step before it. Old logs,
/// from before steps had numbers, have none for replayed steps.
static Revision step_of(const Entry& entry, Revision last) {
  if (entry.kind == EntryKind::join) return last;
  return entry.kind == EntryKind::replay && entry.argument > 0 ? entry.argument : entry.revision;
}

/// Returns the record that the entry makes at `index`, after the record `last`.
History::Record History::next_record(const Entry& entry, std::size_t index, const Record& last) const {
  Record record;
  record.line = line_of(entry);
  record.argument = entry.argument;
  const auto arrive = [&](std::size_t state) {
    record.top = records_[state].top, record.step = records_[state].step;
    record.settings = records_[state].settings;
  };
  switch (entry.kind) {
    case EntryKind::undo:
      arrive(entry.argument == 0 ? records_.size() - 1 : done_[done_.size() - entry.argument].before);
      break;
    case EntryKind::redo:
      arrive(entry.argument == 0 ? records_.size() - 1 : undone_[undone_.size() - entry.argument].after);
      break;
    case EntryKind::revert: arrive(entry.argument - first_); break;
    case EntryKind::command:
    case EntryKind::join:
    case EntryKind::replay:  // its commands follow those in effect before it
      record.top = index, record.step = record.line.step = step_of(entry, last.step);
      record.below = last.top;
      record.settings = entry.settings ? entry.settings : last.settings;
  }
  return record;
}

History::Prepared History::prepare(std::span<const Entry> entries) const {
  assert(!entries.empty() && accepts(entries.front()));
  Prepared prepared;
  std::optional<FieldDelta> step;  // the last step, which a part would join; nothing if only the journal has it
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& entry = entries[i];
    const Record& last = i == 0 ? records_.back() : prepared.changes_.back().record;
    Prepared::Change change{entry.kind, next_record(entry, records_.size() + i, last), {}};
    if (entry.kind == EntryKind::command || entry.kind == EntryKind::revert) {
      step = entry.delta;
    } else if (entry.kind == EntryKind::join || entry.kind == EntryKind::replay) {
      if (i == 0) step = change_in_memory(done_.back());
      if (step) step = compose(*step, entry.delta);
    } else {
      step.reset();
    }
    if (step) change.bytes = encode_delta(*step), change.bytes.shrink_to_fit();
    prepared.changes_.push_back(std::move(change));
  }
  return prepared;
}

/// Returns the change of a step, or nothing if only the journal has it.
std::optional<FieldDelta> History::change_in_memory(const Step& step) const {
  if (step.bytes.empty()) return std::nullopt;
  Result<FieldDelta> decoded = change(step);
  assert(decoded.ok());  // encode_delta wrote the bytes
  return std::move(*decoded);
}

void History::record(const Entry& entry) {
  reserve(1);
  record(prepare(std::span(&entry, 1)));
}

void History::record(Prepared prepared) noexcept {
  for (Prepared::Change& change : prepared.changes_) {
    record_one(change.kind, std::move(change.record), std::move(change.bytes));
  }
}

void History::record_one(EntryKind kind, Record record, std::string bytes) noexcept {
  const auto move_steps = [argument = record.argument](std::vector<Step>& from, std::vector<Step>& to) {
    for (std::uint64_t i = 0; i < argument; ++i) {
      to.push_back(std::move(from.back()));
      from.pop_back();
    }
  };
  switch (kind) {
    case EntryKind::command:
    case EntryKind::revert: add_step(std::move(bytes)); break;
    case EntryKind::join:
    case EntryKind::replay: join_step(std::move(bytes)); break;
    case EntryKind::undo: move_steps(done_, undone_); break;
    case EntryKind::redo: move_steps(undone_, done_); break;
  }
  record.undo_steps = done_.size(), record.redo_steps = undone_.size();
  record_bytes_ += bytes_of(record.line, record.settings != records_.back().settings ? record.settings.get() : nullptr);
  records_.push_back(std::move(record));
  evict_to_budget();
}

/// Adds a step from the last record to the next one, and drops the steps that could be redone.
void History::add_step(std::string bytes) noexcept {
  std::for_each(undone_.begin(), undone_.end(), [&](Step& step) { drop(step); });
  undone_.clear();
  step_bytes_ += bytes.size();
  done_.push_back({std::move(bytes), records_.size() - 1, records_.size()});
}

/// Extends the last step to the next record. If the step's bytes were evicted, the journal has both parts.
void History::join_step(std::string bytes) noexcept {
  Step& step = done_.back();
  step.after = records_.size();
  if (step.bytes.empty()) return;
  drop(step);
  step_bytes_ += bytes.size();
  step.bytes = std::move(bytes);
}

std::vector<LogEntry> History::log() const {
  std::vector<LogEntry> lines;
  std::transform(records_.begin() + 1, records_.end(), std::back_inserter(lines),
                 [](const Record& record) { return record.line; });
  for (std::size_t at = records_.back().top; at != 0; at = records_[at].below) lines[at - 1].in_effect = true;
  return lines;
}

std::vector<LoggedChange> History::changes_after(Revision after, std::size_t max) const {
  assert(after >= first_);
  std::vector<LoggedChange> changes;
  for (std::size_t at = after - first_ + 1; at < records_.size() && changes.size() < max; ++at) {
    const Record& record = records_[at];
    const LogEntry& line = record.line;
    changes.push_back({{.revision = line.revision,
                        .kind = line.kind,
                        .argument = line.kind == name_of(EntryKind::replay) ? 0 : record.argument,
                        .author = line.author,
                        .ops = {},
                        .touched = line.touched,
                        .undo_steps = record.undo_steps,
                        .redo_steps = record.redo_steps},
                       line.commands});
  }
  return changes;
}

std::vector<ListedEntry> History::listed_entries() const {
  std::vector<ListedEntry> entries;
  for (std::size_t at = records_.back().top; at != 0; at = records_[at].below) {
    const LogEntry& line = records_[at].line;
    const bool joins = line.kind == name_of(EntryKind::join);
    entries.push_back({line.step, first_ + at, first_ + records_[at].below, line.commands, joins});
  }
  return entries;
}

std::vector<ListedStep> steps_of(const std::vector<ListedEntry>& entries) {
  std::vector<ListedStep> steps;
  std::optional<ListedStep> later;  // parts that join the next entry in this loop
  for (const ListedEntry& entry : entries) {
    ListedStep step{entry.step, entry.revision, entry.revision, entry.before, commands_to_resend(entry.commands)};
    if (later) {
      prepend_samples(later->commands.front(), step.commands.front());
      step.commands = std::move(later->commands), step.last = later->last;
      later.reset();
    }
    if (entry.joins)
      later = std::move(step);
    else
      steps.push_back(std::move(step));
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

std::vector<std::vector<Command>> commands_of(const std::vector<ListedEntry>& entries) {
  std::vector<std::vector<Command>> log;
  for (ListedStep& step : steps_of(entries)) log.push_back(std::move(step.commands));
  return log;
}

}  // namespace pelage
