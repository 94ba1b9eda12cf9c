#include "server/history/history.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

#include "protocol/json/decode.h"
#include "server/history/delta_codec.h"

namespace pelage {

namespace {

Status too_few(const char* what, std::size_t available) {
  return failure(Code::invalid, std::string("there are fewer steps to ") + what, "/steps",
                 "at most " + std::to_string(available));
}

/// The commands of one log line, ready to be sent whole: strokes without ids and parts.
std::vector<Command> whole_commands(const std::string& text) {
  Result<std::vector<Command>> decoded = decode_commands(text);
  assert(decoded.ok());  // encode wrote it
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

/// Puts the samples of a stroke's later part behind those of its earlier one.
void prepend_samples(Command& later, const Command& earlier) {
  std::vector<StrokeSample>& samples = stroke_of(later)->samples;
  const std::vector<StrokeSample>& first = stroke_of(earlier)->samples;
  samples.insert(samples.begin(), first.begin(), first.end());
}

/// A name that is known moves.
void put_checkpoint(std::vector<Checkpoint>& checkpoints, Checkpoint checkpoint, Revision next) {
  checkpoint.revision = checkpoint.revision.value_or(next);
  const auto same = std::find_if(checkpoints.begin(), checkpoints.end(),
                                 [&](const Checkpoint& other) { return other.name == checkpoint.name; });
  if (same == checkpoints.end())
    checkpoints.push_back(std::move(checkpoint));
  else
    *same = std::move(checkpoint);
}

}  // namespace

std::optional<SceneSettings> with_setting(SceneSettings settings, const Command& command, Revision next) {
  if (const auto* coat = std::get_if<SetCoat>(&command))
    settings.coat = coat->coat;
  else if (const auto* look = std::get_if<SetLook>(&command))
    settings.look = look->look;
  else if (const auto* lights = std::get_if<SetLights>(&command))
    settings.lights = lights->lights;
  else if (const auto* environment = std::get_if<SetEnvironment>(&command))
    settings.environment = environment->environment;
  else if (const auto* ground = std::get_if<SetGround>(&command))
    settings.ground = ground->ground;
  else if (const auto* eyes = std::get_if<SetEyes>(&command))
    settings.eyes = eyes->eyes;
  else if (const auto* curves = std::get_if<SetCurves>(&command))
    settings.curves = curves->groups;
  else if (const auto* skin = std::get_if<SetSkin>(&command))
    settings.skin = skin->regions;
  else if (const auto* base = std::get_if<SetBasePicture>(&command))
    settings.base_picture = base->picture;
  else if (const auto* blowers = std::get_if<SetBlowers>(&command))
    settings.blowers = blowers->blowers;
  else if (const auto* attractors = std::get_if<SetAttractors>(&command))
    settings.attractors = attractors->attractors;
  else if (const auto* symmetry = std::get_if<SetSymmetry>(&command))
    settings.symmetry = symmetry->symmetry;
  else if (const auto* checkpoint = std::get_if<Checkpoint>(&command))
    put_checkpoint(settings.checkpoints, *checkpoint, next);
  else
    return std::nullopt;
  return settings;
}

std::vector<Command> commands_of(const SceneSettings& settings) {
  std::vector<Command> commands{SetCoat{settings.coat},
                                SetLook{settings.look},
                                SetLights{settings.lights},
                                SetEnvironment{settings.environment},
                                SetGround{settings.ground},
                                SetEyes{settings.eyes},
                                SetCurves{settings.curves},
                                SetSkin{settings.skin},
                                SetBasePicture{settings.base_picture},
                                SetBlowers{settings.blowers},
                                SetAttractors{settings.attractors},
                                SetSymmetry{settings.symmetry}};
  commands.insert(commands.end(), settings.checkpoints.begin(), settings.checkpoints.end());
  return commands;
}

const char* name_of(EntryKind kind) {
  static constexpr const char* names[] = {"do", "join", "undo", "redo", "revert"};
  return names[static_cast<std::size_t>(kind)];
}

History::History(Revision first, SceneSettings settings) : first_(first), records_(1) {
  records_[0].settings = std::make_shared<const SceneSettings>(std::move(settings));
}

FieldDelta History::Step::change() const {
  Result<FieldDelta> delta = decode_delta(std::as_bytes(std::span(octets)));
  assert(delta.ok());  // encode_delta wrote it
  return std::move(delta).value();
}

Result<FieldDelta> History::undo(std::uint64_t steps) const {
  if (steps > done_.size()) return too_few("undo", done_.size());
  FieldDelta total;
  for (std::size_t i = 0; i < steps; ++i) total = compose(total, done_[done_.size() - 1 - i].change());
  return total;
}

Result<FieldDelta> History::redo(std::uint64_t steps) const {
  if (steps > undone_.size()) return too_few("redo", undone_.size());
  FieldDelta total;
  for (std::size_t i = 0; i < steps; ++i) total = compose(total, undone_[undone_.size() - 1 - i].change());
  return total;
}

bool History::accepts(const Entry& entry) const {
  if (entry.revision != revision() + 1) return false;
  switch (entry.kind) {
    case EntryKind::command: return true;
    case EntryKind::join: return !done_.empty();
    case EntryKind::undo: return entry.argument <= done_.size();
    case EntryKind::redo: return entry.argument <= undone_.size();
    case EntryKind::revert: return entry.argument >= first_ && entry.argument <= revision();
  }
  return false;
}

void History::record(const Entry& entry) {
  assert(accepts(entry));
  Record record;
  record.line = {entry.revision, name_of(entry.kind), entry.commands, entry.delta.vertices().size()};
  switch (entry.kind) {
    case EntryKind::command: record_do(entry, record); break;
    case EntryKind::join: record_join(entry, record); break;
    case EntryKind::undo: record_undo(entry, record); break;
    case EntryKind::redo: record_redo(entry, record); break;
    case EntryKind::revert: record_revert(entry, record); break;
  }
  records_.push_back(std::move(record));
}

void History::arrive(std::size_t state, Record& record) const {
  record.top = records_[state].top;
  record.settings = records_[state].settings;
}

void History::record_do(const Entry& entry, Record& record) {
  const std::size_t now = records_.size();
  record.top = now;
  record.below = records_.back().top;
  record.settings = entry.settings ? entry.settings : records_.back().settings;
  done_.push_back({encode_delta(entry.delta), now - 1, now});
  undone_.clear();
}

void History::record_join(const Entry& entry, Record& record) {
  const std::size_t now = records_.size();
  record.top = now;
  record.below = records_.back().top;
  record.settings = records_.back().settings;
  done_.back().octets = encode_delta(compose(done_.back().change(), entry.delta));
  done_.back().after = now;
}

void History::record_undo(const Entry& entry, Record& record) {
  for (std::uint64_t i = 0; i < entry.argument; ++i) {
    undone_.push_back(std::move(done_.back()));
    done_.pop_back();
    arrive(undone_.back().before, record);
  }
}

void History::record_redo(const Entry& entry, Record& record) {
  for (std::uint64_t i = 0; i < entry.argument; ++i) {
    done_.push_back(std::move(undone_.back()));
    undone_.pop_back();
    arrive(done_.back().after, record);
  }
}

void History::record_revert(const Entry& entry, Record& record) {
  arrive(entry.argument - first_, record);
  done_.push_back({encode_delta(entry.delta), records_.size() - 1, records_.size()});
  undone_.clear();
}

std::vector<LogEntry> History::log() const {
  std::vector<LogEntry> lines;
  std::transform(records_.begin() + 1, records_.end(), std::back_inserter(lines),
                 [](const Record& record) { return record.line; });
  return lines;
}

std::vector<std::vector<Command>> History::effective_log() const {
  std::vector<std::vector<Command>> steps;
  std::optional<Command> later;  // parts that join the entry below
  for (std::size_t at = records_.back().top; at != 0; at = records_[at].below) {
    std::vector<Command> commands = whole_commands(records_[at].line.commands);
    if (later) {
      prepend_samples(*later, commands.front());
      commands.front() = std::exchange(later, std::nullopt).value();
    }
    if (records_[at].line.kind == name_of(EntryKind::join))
      later = std::move(commands.front());
    else
      steps.push_back(std::move(commands));
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

}  // namespace pelage
