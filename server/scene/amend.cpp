// Changing an earlier step: what follows is evaluated anew, beside the scene, and then taken over as a whole.
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

/// A refusal of a step that was fine before the amendment. Where it stands in that step does not help whoever amends.
Status not_replayed(const ListedStep& step, Status reason) {
  reason.message = "the step of revision " + std::to_string(step.first) + " cannot be replayed: " + reason.message;
  reason.pointer = "/commands";
  return reason;
}

}  // namespace

Result<CommandAnswer> Scene::amend(const AmendRequest& request, const ExecuteOptions& options) {
  const std::lock_guard changing(changing_);
  if (Status refused = admit(options); !refused.ok()) return refused;
  const std::vector<ListedStep> steps = history_.listed_steps();
  const auto amended = std::find_if(steps.begin(), steps.end(), [&](const ListedStep& step) {
    return step.number == request.revision || (step.first <= request.revision && request.revision <= step.last);
  });
  if (amended == steps.end()) return not_in_effect();

  // Beside the scene: nothing has changed yet.
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
  entry.revision = history_.revision() + 1, entry.kind = EntryKind::revert, entry.argument = before;
  entry.delta = difference(*fields_, *then);
  entry.fields_hash = then->hash();
  return Replay{std::move(*then), history_.settings_at(before), {std::move(entry)}, {}};
}

/// Evaluates one step on the result of the steps before it. Its entry has its own revision, which its checkpoints name.
Status Scene::replay_step(Replay& replay, Revision number, const std::vector<Command>& commands,
                          const ExecuteOptions& options) const {
  const auto replayed_fields_at = [&](Revision revision) -> Result<FieldSet> {
    if (revision <= history_.revision()) return fields_at(revision);
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
    const Status parts = check_whole(commands[k]);
    Result<Step> step = parts.ok() ? prepare(commands[k], resolved, past) : parts;
    if (!step) {
      Status refused = step.status();
      refused.pointer.insert(0, "/commands/" + std::to_string(k));
      return refused;
    }
    resolved.push_back(step->command);
    steps.push_back(std::move(*step));
  }
  if (Status too_costly = check_cost(steps, replay.settings->symmetry, model_->surface, replay.fields);
      !too_costly.ok()) {
    if (steps.size() == 1) too_costly.pointer.insert(0, "/commands/0");  // as the other refusals here
    return too_costly;
  }
  const Revision next = replay.entries.back().revision + 1;
  Result<Outcome> evaluated =
      evaluate_batch(steps, {}, model_->surface, replay.fields, *replay.settings, next, options.cancel);
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

// A scene's past beside its present: branches, the fields of an earlier revision, and what has changed since.

Result<std::shared_ptr<Scene>> Scene::branch(const std::string& id, const std::string& name, std::optional<Revision> at,
                                             std::uint64_t copy_id, const std::optional<KeyedRequest>& request) const {
  const Snapshot now = snapshot();
  const Revision last = at.value_or(now.revision);
  if (Status bad = has_revision(last); !bad.ok()) return bad;
  if (Status written = journal_.branch(id_, id, name, last, request); !written.ok()) return written;
  const Result<StoredScene> stored = journal_.scene(id);
  auto scene = std::make_shared<Scene>(id, name, now.model, FirstGroom{}, journal_, undo_bytes_);
  scene->copy_id_ = copy_id;
  Status restored = stored ? scene->restore(stored->first_groom, stored->first_revision, stored->first_settings)
                           : Status(stored.status());
  if (restored.ok() && scene->revision() == last) return scene;
  scene->remove();
  if (Status gone = has_revision(last); !gone.ok()) return gone;  // it got another model or was removed meanwhile
  return restored;
}

Status Scene::check_revision(Revision revision, std::string pointer) const {
  if (revision >= history_.first_revision() && revision <= history_.revision()) return {};
  return failure(Code::invalid, "there is no such revision of this model", std::move(pointer),
                 "[" + std::to_string(history_.first_revision()) + ", " + std::to_string(history_.revision()) + "]");
}

Status Scene::has_revision(Revision revision) const {
  const std::lock_guard lock(mutex_);
  if (Status removed = gone(); !removed.ok()) return removed;
  return check_revision(revision);
}

Result<Scene::Snapshot> Scene::snapshot_with(Revision revision, const std::string& pointer) const {
  const std::lock_guard lock(mutex_);
  if (Status bad = check_revision(revision, pointer); !bad.ok()) return bad;
  return present();
}

/// Computes the fields of an earlier revision from the current ones by the journal's changes.
Result<FieldSet> Scene::fields_before(const Snapshot& now, Revision revision) const {
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
  return fields_before(present(), revision);
}

Result<PastFields> Scene::past_fields(Revision revision, const std::string& pointer) const {
  const Result<Snapshot> now = snapshot_with(revision, pointer);
  if (!now) return now.status();
  Result<FieldSet> then = fields_before(*now, revision);
  if (then) return PastFields{now->model, std::move(*then)};
  // Entries stay for as long as their model does. Where that went meanwhile, its entries were missing.
  const std::lock_guard lock(mutex_);
  if (Status removed = gone(); !removed.ok()) return removed;
  if (Status bad = check_revision(revision, pointer); !bad.ok()) return bad;
  return then.status();
}

Result<Comparison> Scene::compare(Revision from, Revision to) const {
  const Result<PastFields> before = past_fields(from, "/from");
  if (!before) return before.status();
  const Result<PastFields> after = past_fields(to, "/to");
  if (!after) return after.status();
  if (before->model != after->model) return failure(Code::conflict, "the scene got another model meanwhile");
  const FieldDelta delta = difference(before->fields, after->fields);
  return Comparison{from, to, delta.vertices().size(), measure(delta, before->fields)};
}

Result<std::shared_ptr<const SceneSettings>> Scene::settings_at(Revision revision) const {
  const std::lock_guard lock(mutex_);
  if (Status bad = check_revision(revision); !bad.ok()) return bad;
  return history_.settings_at(revision);
}

Result<SettingsAnswer> Scene::settings(std::optional<Revision> revision) const {
  const Snapshot now = snapshot();
  if (!revision) return SettingsAnswer{now.revision, *now.settings};
  const auto settings = settings_at(*revision);
  if (!settings) return settings.status();
  return SettingsAnswer{*revision, **settings};
}

/// No two models of a scene have a revision in common, so that all of this is of one model.
Result<SceneCopy> Scene::copy_at(Revision revision, std::uint64_t copy_id) const {
  const auto settings = settings_at(revision);
  if (!settings) return settings.status();
  Result<PastFields> past = past_fields(revision, "/revision");
  if (!past) return past.status();
  Result<LaidPicture> picture = picture_of(**settings, snapshot().picture);
  if (!picture) return picture.status();
  return SceneCopy(std::move(*past), *settings, std::move(picture->image), revision, copy_id);
}

}  // namespace pelage
