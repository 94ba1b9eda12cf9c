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
  const std::lock_guard lock(mutex_);
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

/// Goes back to a revision.
Result<Scene::Replay> Scene::begin_replay(Revision before) const {
  Result<FieldSet> then = fields_at(before);
  if (!then) return then.status();
  Entry entry;
  entry.revision = history_.revision() + 1, entry.kind = EntryKind::revert, entry.argument = before;
  entry.delta = difference(fields_, *then);
  entry.fields_hash = then->hash();
  auto settings = std::make_shared<const SceneSettings>(history_.settings_at(before));
  return Replay{std::move(*then), std::move(settings), {std::move(entry)}, {}};
}

/// Evaluates one step on what those before it left. Its entry has a revision of its own, which its checkpoints name.
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
  const Past past{*replay.settings, replayed_fields_at, options.sources, pictures};
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
  if (Status dear = check_cost(steps, replay.settings->symmetry, model_->surface); !dear.ok()) {
    if (steps.size() == 1) dear.pointer.insert(0, "/commands/0");  // as the other refusals here
    return dear;
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
                                             std::uint64_t copy_id) const {
  std::shared_ptr<const SceneModel> model;
  {
    const std::lock_guard lock(mutex_);
    if (Status gone = admit({}); !gone.ok()) return gone;
    const Revision last = at.value_or(history_.revision());
    if (Status bad = check_revision(last); !bad.ok()) return bad;
    if (Status written = journal_.branch(id_, id, name, last); !written.ok()) return written;
    model = model_;
  }
  const Result<StoredScene> stored = journal_.scene(id);
  auto scene = std::make_shared<Scene>(id, name, std::move(model), FirstGroom{}, journal_, undo_bytes_);
  scene->copy_id_ = copy_id;
  Status restored =
      stored ? scene->restore(stored->first_groom, stored->first_revision, stored->first_settings) : stored.status();
  if (restored.ok()) return scene;
  scene->remove();
  return restored;
}

Status Scene::check_revision(Revision revision, std::string pointer) const {
  if (revision >= history_.first_revision() && revision <= history_.revision()) return {};
  return failure(Code::invalid, "there is no such revision of this model", std::move(pointer),
                 "[" + std::to_string(history_.first_revision()) + ", " + std::to_string(history_.revision()) + "]");
}

Result<FieldSet> Scene::fields_at(Revision revision) const {
  if (Status bad = check_revision(revision); !bad.ok()) return bad;
  FieldSet then = fields_;
  bool fits = true;
  Status read = journal_.for_each_change(id_, revision, history_.revision(), [&](const FieldDelta& delta) {
    fits = fits && then.accepts(delta);
    if (fits) then.apply(delta);
  });
  if (!read.ok()) return read;
  return fits ? Result<FieldSet>(std::move(then)) : damaged_journal();
}

Result<Comparison> Scene::compare(Revision from, Revision to) const {
  const std::lock_guard lock(mutex_);
  if (Status bad = check_revision(from, "/from"); !bad.ok()) return bad;
  if (Status bad = check_revision(to, "/to"); !bad.ok()) return bad;
  const Result<FieldSet> before = fields_at(from), after = fields_at(to);
  if (!before) return before.status();
  if (!after) return after.status();
  const FieldDelta delta = difference(*before, *after);
  return Comparison{from, to, delta.vertices().size(), measure(delta, *before)};
}

Result<SettingsAnswer> Scene::settings(std::optional<Revision> revision) const {
  const std::lock_guard lock(mutex_);
  const Revision at = revision.value_or(history_.revision());
  if (Status bad = check_revision(at); !bad.ok()) return bad;
  return SettingsAnswer{at, history_.settings_at(at)};
}

Status Scene::has_revision(Revision revision) const {
  const std::lock_guard lock(mutex_);
  return check_revision(revision);
}

Result<SceneCopy> Scene::copy_at(Revision revision, std::uint64_t copy_id) const {
  Result<PastFields> past = past_fields(revision, "/revision");
  if (!past) return past.status();
  const std::lock_guard lock(mutex_);
  if (Status gone = check_revision(revision); !gone.ok()) return gone;  // with the model, meanwhile
  const SceneSettings& settings = history_.settings_at(revision);
  Result<LaidPicture> picture = picture_of(settings);
  if (!picture) return picture.status();
  return SceneCopy(std::move(*past), settings, std::move(picture->image), revision, copy_id);
}

Result<PastFields> Scene::past_fields(Revision revision, const std::string& pointer) const {
  std::unique_lock lock(mutex_);
  if (Status bad = check_revision(revision, pointer); !bad.ok()) return bad;
  PastFields past{model_, fields_};
  const Revision present = history_.revision();
  lock.unlock();  // entries stay as they are for as long as the model does
  bool fits = true;
  Status read = journal_.for_each_change(id_, revision, present, [&](const FieldDelta& delta) {
    fits = fits && past.fields.accepts(delta);
    if (fits) past.fields.apply(delta);
  });
  if (read.ok() && fits) return past;
  lock.lock();
  if (Status gone = admit({}); !gone.ok()) return gone;
  if (Status bad = check_revision(revision, pointer); !bad.ok()) return bad;
  return read.ok() ? damaged_journal() : read;
}

}  // namespace pelage
