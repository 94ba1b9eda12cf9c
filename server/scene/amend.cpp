// Amends an earlier step of the log: the steps from there on are evaluated again on copies, then committed together.
#include <algorithm>
#include <string>
#include <utility>

#include "protocol/json/encode.h"
#include "server/history/journal.h"
#include "server/scene/batch.h"
#include "server/scene/scene.h"

namespace pelage {

namespace {

Status not_in_effect() {
  return failure(Code::invalid, "no step that is in effect has this revision", "/revision",
                 "the number of a step of the log, or a revision that made, joined or replayed it, that is not undone "
                 "or reverted past");
}

/// Returns the error for a later step that the amendment makes invalid. The pointer into that step is dropped, because
/// it does not help the client who amends.
Status not_replayed(const ListedStep& step, Status reason) {
  reason.message = "the step of revision " + std::to_string(step.first) + " cannot be replayed: " + reason.message;
  reason.pointer = "/commands";
  return reason;
}

}  // namespace

Result<CommandAnswer> Scene::amend(const AmendRequest& request, const ExecuteOptions& options) {
  const Result<ChangeTurns::Turn> turn = begin_change(options);
  if (!turn) return turn.status();
  const std::vector<ListedStep> steps = history_.listed_steps();
  const auto amended = std::find_if(steps.begin(), steps.end(), [&](const ListedStep& step) {
    return step.number == request.revision || (step.first <= request.revision && request.revision <= step.last);
  });
  if (amended == steps.end()) return not_in_effect();

  // Evaluate on copies: the scene stays unchanged until the commit.
  Result<Replay> replay = begin_replay(amended->before);
  if (!replay) return replay.status();
  replay->entries.front().author = options.author;
  replay->entries.front().request = options.request;
  if (Status refused = replay_step(*replay, amended->number, request.commands, options); !refused.ok()) return refused;
  for (auto later = amended + 1; later != steps.end(); ++later) {
    if (Status refused = replay_step(*replay, later->number, later->commands, options); !refused.ok())
      return refused.code == Code::unavailable ? refused : not_replayed(*later, refused);
  }

  if (!options.dry_run) {
    if (Status written = commit(replay->entries, std::move(replay->fields), {}); !written.ok()) return written;
  }
  return answer(std::move(replay->results));
}

/// Begins a replay with an entry that reverts the scene to a revision.
Result<Scene::Replay> Scene::begin_replay(Revision before) const {
  Result<FieldSet> then = fields_at(before);
  if (!then) return then.status();
  Entry entry;
  entry.revision = present_->revision + 1, entry.kind = EntryKind::revert, entry.argument = before;
  entry.delta = difference(*present_->fields, *then);
  entry.fields_hash = then->hash();
  return Replay{std::move(*then), history_.settings_at(before), {std::move(entry)}, {}};
}

/// Evaluates one step on the result of the steps before it. Its entry gets a revision of its own, which checkpoints set
/// in that step then name.
Status Scene::replay_step(Replay& replay, Revision number, const std::vector<Command>& commands,
                          const ExecuteOptions& options) const {
  const auto replayed_fields_at = [&](Revision revision) -> Result<FieldSet> {
    if (revision <= present_->revision) return fields_at(revision);
    FieldSet then = replay.fields;
    for (const Entry& entry : replay.entries) {
      if (entry.revision > revision) then.apply(entry.delta);
    }
    return then;
  };
  BatchPictures pictures(journal_);
  double visits = 0;
  const Past past{*replay.settings, replay.fields, replayed_fields_at, options, pictures, visits};
  std::vector<Step> steps;
  std::vector<Command> resolved;
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const Status parts = check_complete_stroke(commands[k]);
    Result<Step> step = parts.ok() ? prepare(commands[k], resolved, past) : parts;
    if (!step) {
      Status refused = step.status();
      refused.pointer.insert(0, "/commands/" + std::to_string(k));
      return refused;
    }
    resolved.push_back(step->command);
    steps.push_back(std::move(*step));
  }
  const Surface& surface = present_->model->surface;
  if (Status too_costly = check_cost(steps, replay.settings->symmetry, surface, replay.fields); !too_costly.ok()) {
    if (steps.size() == 1) too_costly.pointer.insert(0, "/commands/0");  // as in the other errors of this function
    return too_costly;
  }
  const Revision next = replay.entries.back().revision + 1;
  Result<Outcome> evaluated = evaluate_batch(steps, {}, surface, replay.fields, *replay.settings, next, options.cancel);
  if (!evaluated) return evaluated.status();
  Outcome& outcome = *evaluated;
  std::move(outcome.results.begin(), outcome.results.end(), std::back_inserter(replay.results));
  if (!outcome.changed()) return {};
  replay.fields = std::move(outcome.fields);
  if (outcome.settings) replay.settings = outcome.settings;
  const std::vector<Command> logged = chosen(resolved, outcome.effective);
  replay.entries.push_back({next, EntryKind::replay, number, encode(logged), std::move(outcome.delta),
                            replay.fields.hash(), outcome.settings, pictures_read_by(logged), options.author,
                            options.request});
  return {};
}

// Access to earlier revisions: branches, fields and settings at a revision, and comparisons.

Result<std::shared_ptr<Scene>> Scene::branch(const std::string& id, const std::string& name, std::optional<Revision> at,
                                             std::uint64_t copy_id, const std::optional<KeyedRequest>& request) const {
  const SnapshotPtr now = snapshot();
  const Revision last = at.value_or(now->revision);
  if (Status bad = has_revision(last); !bad.ok()) return bad;
  if (Status written = journal_.branch(id_, id, name, last, request); !written.ok()) return written;
  const Result<StoredScene> stored = journal_.scene(id);
  auto scene = std::make_shared<Scene>(id, name, now->model, FirstGroom{}, journal_, undo_bytes_);
  auto own = std::make_shared<SceneSnapshot>(*scene->present_);
  own->copy_id = copy_id;
  scene->present_ = std::move(own);
  Status restored = stored ? scene->restore(stored->first_groom, stored->first_revision, stored->first_settings)
                           : Status(stored.status());
  if (restored.ok() && scene->revision() == last) return scene;
  scene->remove();
  if (Status gone = has_revision(last); !gone.ok()) return gone;  // removed, or got another model, meanwhile
  return restored;
}

Status Scene::check_revision(Revision revision, const std::string& pointer) const {
  const Revision first = history_.first_revision(), last = present_->revision;
  if (revision >= first && revision <= last) return {};
  return failure(Code::invalid, "there is no such revision of this model", pointer,
                 "[" + std::to_string(first) + ", " + std::to_string(last) + "]");
}

Status Scene::has_revision(Revision revision) const {
  const std::lock_guard lock(mutex_);
  if (Status removed = gone(); !removed.ok()) return removed;
  return check_revision(revision);
}

/// Computes the fields of an earlier revision by applying the journal's changes since then to the current fields. The
/// changes are bit flips, so that their order does not matter.
Result<FieldSet> Scene::fields_before(const SceneSnapshot& now, Revision revision) const {
  FieldSet then = *now.fields;
  bool fits = true;
  Status read = journal_.for_each_change(id_, revision, now.revision, [&](const FieldDelta& delta) {
    fits = fits && then.accepts(delta);
    if (fits) then.apply(delta);
  });
  if (!read.ok()) return read;
  return fits ? Result<FieldSet>(std::move(then)) : damaged_journal();
}

Result<FieldSet> Scene::fields_at(Revision revision) const {
  if (Status bad = check_revision(revision); !bad.ok()) return bad;
  return fields_before(*present_, revision);
}

Result<SceneSnapshot> Scene::snapshot_at(Revision revision, const std::string& pointer) const {
  SnapshotPtr now;
  SceneSnapshot then;
  {
    const std::lock_guard lock(mutex_);
    if (Status bad = check_revision(revision, pointer); !bad.ok()) return bad;
    now = present_;
    then.settings = history_.settings_at(revision);
  }
  if (revision == now->revision) return *now;
  then.model = now->model, then.revision = revision;
  Result<FieldSet> fields = fields_before(*now, revision);
  auto texture = skin_texture_of(*then.settings, now.get());
  if (fields && texture) {
    then.fields = std::make_shared<const FieldSet>(std::move(*fields));
    then.skin_texture = std::move(*texture);
    return then;
  }
  // Entries are missing if the scene got another model or was removed meanwhile. Then that is the error to return.
  const std::lock_guard lock(mutex_);
  if (Status removed = gone(); !removed.ok()) return removed;
  if (Status bad = check_revision(revision, pointer); !bad.ok()) return bad;
  return fields ? texture.status() : fields.status();
}

Result<Comparison> Scene::compare(Revision from, Revision to) const {
  const Result<SceneSnapshot> before = snapshot_at(from, "/from");
  if (!before) return before.status();
  const Result<SceneSnapshot> after = snapshot_at(to, "/to");
  if (!after) return after.status();
  if (before->model != after->model) return failure(Code::conflict, "the scene got another model meanwhile");
  const FieldDelta delta = difference(*before->fields, *after->fields);
  return Comparison{from, to, delta.vertices().size(), measure(delta, *before->fields)};
}

Result<SettingsAnswer> Scene::settings(std::optional<Revision> revision) const {
  const std::lock_guard lock(mutex_);
  if (!revision) return SettingsAnswer{present_->revision, *present_->settings};
  if (Status bad = check_revision(*revision); !bad.ok()) return bad;
  return SettingsAnswer{*revision, *history_.settings_at(*revision)};
}

}  // namespace pelage
