#include "server/scene/scene.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <span>
#include <utility>

#include "protocol/json/encode.h"
#include "protocol/json/names.h"
#include "server/fields/coats.h"
#include "server/groom/first_groom.h"
#include "server/history/journal.h"
#include "server/import/import.h"
#include "server/scene/batch.h"
#include "server/scene/creature_settings.h"
#include "server/scene/map_pictures.h"
#include "server/scene/model.h"
#include "server/scene/pick.h"

namespace pelage {

namespace {

Status quarantined(const std::string& damage) {
  return with_next(failure(Code::conflict, "the scene cannot be changed: " + damage),
                   "branch it, or export it as .pelage and open that: both have all that is whole");
}

}  // namespace

Scene::Scene(std::string id, std::string name, std::shared_ptr<const SceneModel> model, FirstGroom fur,
             Journal& journal, std::size_t undo_bytes, const SceneSettings* settings)
    : id_(std::move(id)),
      name_(std::move(name)),
      journal_(journal),
      undo_bytes_(undo_bytes),
      history_(new_history(0, settings != nullptr ? *settings : first_settings(*model))) {
  FieldSet fields = first_groom(model->surface.mesh(), fur);
  present_ = first_snapshot(std::move(model), std::move(fields), history_, nullptr);
}

/// Makes a history that reads steps beyond the memory budget back from the journal, which has every entry.
History Scene::new_history(Revision first, SceneSettings settings) const {
  const auto read = [&journal = journal_, id = id_](Revision from, Revision to) {
    return journal.change(id, from, to);
  };
  return History(first, std::move(settings), {undo_bytes_, read});
}

Status Scene::restore(const FieldDelta& first_groom, Revision first,
                      const std::shared_ptr<const SceneSettings>& settings) {
  FieldSet fields(present_->fields->size());
  History history = new_history(first, settings ? *settings : first_settings(*present_->model));
  if (!fields.accepts(first_groom)) return damaged_journal();
  fields.apply(first_groom);
  Status taken = journal_.for_each_entry(id_, first, [&](const Entry& entry) {
    if (!history.accepts(entry) || !fields.accepts(entry.delta)) return damaged_journal();
    fields.apply(entry.delta);
    if (fields.hash() != entry.fields_hash) return fields.apply(entry.delta), damaged_journal();  // undoes apply
    history.record(entry);
    return Status{};
  });
  auto texture = skin_texture_of(history.settings(), nullptr);
  if (taken.ok() && !texture) taken = texture.status();
  SnapshotPtr restored = first_snapshot(present_->model, std::move(fields), history, texture ? *texture : nullptr);
  const Status begun = replace_state(restored, history, [] { return Status{}; });  // also if it is damaged
  return taken.ok() ? begun : taken;
}

void Scene::quarantine(const std::string& why) {
  const std::lock_guard lock(mutex_);
  damage_ = why;
  publish_revision();
}

// Runs the stages of a stroke. Decoding comes before them and drawing after them, each on its own thread.
Result<CommandAnswer> Scene::execute(const std::vector<Command>& commands, const ExecuteOptions& options) {
  const Result<ChangeTurns::Turn> turn = begin_change(options);
  if (!turn) return turn.status();

  // Resolve: pixels become positions on the surface, and a part of a live stroke becomes the whole stroke so far.
  const Result<Plan> planned = plan(commands, options);
  if (!planned) return planned.status();
  const SceneSnapshot& now = *present_;
  if (Status too_costly = check_cost(planned->merged, now.settings->symmetry, now.model->surface, *now.fields);
      !too_costly.ok())
    return too_costly;

  // Evaluate. This is pure: nothing has changed yet.
  const Result<FieldDelta> start = planned->joins ? history_.last_step() : FieldDelta{};
  if (!start) return start.status();
  Result<Outcome> evaluated = evaluate_batch(planned->merged, *start, now.model->surface, *now.fields, *now.settings,
                                             now.revision + 1, options.cancel);
  if (!evaluated) return evaluated.status();
  Outcome& outcome = *evaluated;
  if (options.dry_run) return answer(std::move(outcome.results));
  const bool changed = outcome.changed();

  // A following part of this stroke can join the step; any other change ends the stroke.
  LiveStroke live = live_;
  if (commands.size() == 1) {
    live.accept({planned->merged[0].command, planned->to_log[0], planned->joins}, commands[0], changed);
  } else if (changed) {
    live.end();
  }

  // Commit: first to disk, and only then to the fields and the log. A stroke that changes nothing makes no step.
  if (changed) {
    const EntryKind kind = planned->joins ? EntryKind::join : EntryKind::command;
    const std::vector<Command> to_log = chosen(planned->to_log, outcome.effective);
    const Entry entry{now.revision + 1,
                      kind,
                      0,
                      encode(to_log),
                      std::move(outcome.delta),
                      outcome.fields.hash(),
                      outcome.settings,
                      pictures_read_by(to_log),
                      options.author,
                      options.request};
    Status written = commit(std::span(&entry, 1), std::move(outcome.fields), std::move(live));
    if (!written.ok()) return written;
  } else {
    const std::lock_guard lock(mutex_);
    live_ = std::move(live);
  }
  return answer(std::move(outcome.results));
}

// Undo, redo and revert run the same stages with a stored change.
Result<CommandAnswer> Scene::move(const HistoryMove& move, const ExecuteOptions& options) {
  const Result<ChangeTurns::Turn> turn = begin_change(options);
  if (!turn) return turn.status();
  Result<Entry> entry = entry_of(move);
  if (!entry) return entry.status();
  entry->author = options.author;
  entry->request = options.request;
  std::vector<CommandResult> results{describe_change(name_of(entry->kind), entry->delta, *present_->fields)};
  const bool stays = entry->kind == EntryKind::revert && entry->argument == present_->revision;
  if (!options.dry_run && !stays) {
    FieldSet after = *present_->fields;
    after.apply(entry->delta);
    if (Status written = commit(std::span(&*entry, 1), std::move(after), {}); !written.ok()) return written;
  }
  return answer(std::move(results));
}

Status Scene::gone() const { return removed_ ? failure(Code::not_found, "the scene has been removed") : Status{}; }

Result<ChangeTurns::Turn> Scene::begin_change(const ExecuteOptions& options) {
  Result<ChangeTurns::Turn> turn = turns_.take(options.cancel);
  if (!turn) return turn;
  if (options.cancel.asked()) return nobody_waits();
  if (Status removed = gone(); !removed.ok()) return removed;
  if (!damage_.empty()) return quarantined(damage_);
  if (!options.if_match || *options.if_match == present_->revision) return turn;
  return failure(Code::precondition, "the scene is at revision " + std::to_string(present_->revision));
}

SnapshotPtr Scene::snapshot() const {
  const std::lock_guard lock(mutex_);
  return present_;
}

void Scene::pose(std::optional<ScenePose> pose) {
  [[maybe_unused]] const Result<ChangeTurns::Turn> turn = turns_.take();
  assert(turn.ok());
  auto posed = std::make_shared<SceneSnapshot>(*present_);
  const Mesh& mesh = posed->model->surface.mesh();
  assert(!pose || pose->model->surface.mesh().triangles.size() == mesh.triangles.size());
  posed->pose = pose ? std::make_shared<const ScenePose>(std::move(*pose)) : nullptr;
  posed->changes = posed->changes.with(full_vertex_range(mesh.positions.size()));
  const std::lock_guard lock(mutex_);
  present_ = std::move(posed);
}

Result<Entry> Scene::entry_of(const HistoryMove& move) const {
  Entry entry;
  entry.revision = present_->revision + 1;
  Result<FieldDelta> delta = FieldDelta{};
  if (const auto* undo = std::get_if<Undo>(&move)) {
    entry.kind = EntryKind::undo;
    entry.argument = static_cast<std::uint64_t>(std::max(undo->steps, 1));
    delta = history_.undo(entry.argument);
  } else if (const auto* redo = std::get_if<Redo>(&move)) {
    entry.kind = EntryKind::redo;
    entry.argument = static_cast<std::uint64_t>(std::max(redo->steps, 1));
    delta = history_.redo(entry.argument);
  } else {
    entry.kind = EntryKind::revert;
    entry.argument = std::get<Revert>(move).revision;
    const Result<FieldSet> then = fields_at(entry.argument);
    if (!then) return then.status();
    delta = difference(*present_->fields, *then);
  }
  if (!delta) return delta.status();
  entry.delta = std::move(*delta);
  entry.fields_hash = present_->fields->hash_after(entry.delta);
  return entry;
}

CommandAnswer Scene::answer(std::vector<CommandResult> results) const {
  return {present_->revision, present_->fields->hash(), std::move(results)};
}

SceneSummary Scene::summary() const {
  const std::lock_guard lock(mutex_);
  const SceneModel& model = *present_->model;
  return {id_,
          name_,
          present_->revision,
          model.name,
          model.mesh_id,
          json_names::word_of(json_names::fur_patches, model.fur_patches),
          metres_of(model.name),
          model.surface.mesh().report,
          present_->fields->hash(),
          history_.undo_steps(),
          history_.redo_steps(),
          names_of(present_->settings->coats),
          present_->settings->layers,
          damage_};
}

std::vector<LogEntry> Scene::log() const {
  const std::lock_guard lock(mutex_);
  return history_.log();
}

std::vector<std::vector<Command>> Scene::effective_log() const {
  std::vector<ListedEntry> listed;
  {
    const std::lock_guard lock(mutex_);
    listed = history_.listed_entries();
  }
  return commands_of(listed);
}

Result<MapFile> Scene::draw_map(const MapRequest& request) const {
  const SnapshotPtr now = snapshot();
  const NamedCoat* coat = find_coat(now->settings->coats, request.coat);
  if (!coat) return failure(Code::invalid, "the scene has no coat of this name", "/coat");
  Result<MapFile> file = make_map_file(now->model->surface.mesh(), now->fields->of_coat(coat->id), request);
  if (file) file->answer.revision = now->revision;
  return file;
}

Result<PickAnswer> Scene::pick(const PickRequest& wanted, const std::string& coat) const {
  const SnapshotPtr now = snapshot();
  const std::vector<NamedCoat>& coats = now->settings->coats;
  const NamedCoat* asked = coat.empty() ? nullptr : find_coat(coats, coat);  // null if the coat was removed meanwhile
  return pelage::pick(now->model->surface, now->fields->of_coat((asked ? *asked : first_unmuted(coats)).id), wanted);
}

Status Scene::rename(const std::string& name) {
  const Result<ChangeTurns::Turn> turn = begin_change({});
  if (!turn) return turn.status();
  return take_over([&] { return journal_.rename_scene(id_, name); }, [&] { name_ = name; });
}

/// Does not wait for a change that is being evaluated; it will find the scene gone.
Status Scene::remove() {
  const std::lock_guard writing(writing_);
  if (Status removed = gone(); !removed.ok()) return removed;
  if (Status failed = journal_.remove_scene(id_); !failed.ok()) return failed;
  const std::lock_guard lock(mutex_);
  removed_ = true;
  publish_revision();
  return {};
}

Revision Scene::wait_newer(Revision after, double seconds, const std::function<bool()>& or_else) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                    [&] { return removed_ || history_.revision() > after || (or_else && or_else()); });
  return history_.revision();
}

void Scene::wake() const {
  const std::lock_guard lock(mutex_);
  changed_.notify_all();
}

Revision Scene::revision() const {
  const std::lock_guard lock(mutex_);
  return history_.revision();
}

const std::string& Scene::id() const { return id_; }

}  // namespace pelage
