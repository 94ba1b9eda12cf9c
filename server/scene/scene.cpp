#include "server/scene/scene.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <span>
#include <utility>

#include "protocol/json/encode.h"
#include "protocol/json/names.h"
#include "server/fields/coats.h"
#include "server/fields/edit_layers.h"
#include "server/groom/evaluate.h"
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

/// Returns the step of a retarget: its source, and the command with the source's revision filled in.
Result<Step> with_source(Retarget command, const std::vector<GroomSource>& sources) {
  const auto source = std::find_if(sources.begin(), sources.end(), [&](const GroomSource& one) {
    return one.scene == command.scene && one.asked == command.revision;
  });
  if (source == sources.end())
    return failure(Code::invalid, "the server has no such scene to take fields from", "/scene");
  command.revision = source->revision;
  return Step{std::move(command), source->fields, {source->model, &source->model->surface}};
}

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

Result<Scene::Plan> Scene::plan(const std::vector<Command>& commands, const ExecuteOptions& options) const {
  Plan plan;
  BatchPictures pictures(journal_);
  // A later part of a stroke sees the fur as it was before the stroke, so that parts give the same result as the whole
  // stroke at once.
  std::optional<FieldSet> before_stroke;
  if (commands.size() == 1 && live_.joins(commands.front())) {
    const Result<FieldDelta> so_far = history_.last_step();
    if (!so_far) return so_far.status();
    before_stroke.emplace(*present_->fields).apply(*so_far);
  }
  const FieldSet& seen = before_stroke ? *before_stroke : *present_->fields;
  double visits = 0;
  const Past past{
      *present_->settings, seen, [this](Revision revision) { return fields_at(revision); }, options, pictures, visits};
  for (std::size_t k = 0; k < commands.size(); ++k) {
    Status parts = commands.size() > 1 ? check_complete_stroke(commands[k]) : Status{};
    Result<Step> step = parts.ok() ? prepare(commands[k], plan.to_log, past) : parts;
    if (!step) return in_batch(step.status(), k, commands.size());
    plan.to_log.push_back(step->command);
    plan.merged.push_back(std::move(*step));
  }
  if (commands.size() != 1) return plan;
  Result<LiveStroke::Plan> live = live_.plan(plan.to_log.front());
  if (!live) return live.status();
  if (live->joins) {  // the whole stroke may exceed a limit although no single part does
    if (Result<Command> checked = resolve(live->merged, present_->model->surface); !checked) return checked.status();
  }
  plan.merged.front().command = std::move(live->merged);
  plan.to_log.front() = std::move(live->to_log);
  plan.joins = live->joins;
  return plan;
}

/// Returns a command ready for evaluation: resolved, and with the fields and pictures that it names.
Result<Step> Scene::prepare(const Command& command, const std::vector<Command>& before, const Past& past) const {
  const VisibleFur fur{past.fields, past.settings.coats, past.visits, past.options.cancel};
  Result<Command> resolved = resolve(command, present_->model->surface, &fur);
  if (!resolved) return resolved.status();
  if (Status missing = check_names(*resolved, before, past.settings); !missing.ok()) return missing;
  const auto* retarget = std::get_if<Retarget>(&*resolved);
  Result<Step> step =
      retarget ? with_source(*retarget, past.options.sources) : with_baseline(std::move(*resolved), past);
  if (!step) return step;
  auto pictures = past.pictures.find(step->command, present_->model->surface.mesh().positions.size());
  if (!pictures) return pictures.status();
  step->pictures = std::move(*pictures);
  return step;
}

/// Checks that everything a command names exists in the scene or is made by earlier commands of its batch.
Status Scene::check_names(const Command& command, const std::vector<Command>& before, SceneSettings settings) const {
  for (const Command& earlier : before) settings = with_setting(settings, earlier).value_or(settings);
  const auto missing = [](const auto& list, const std::string& name) {
    return !name.empty() &&
           std::none_of(list.begin(), list.end(), [&](const auto& named) { return named.name == name; });
  };
  if (const auto* blow = std::get_if<Blow>(&command); blow && missing(settings.blowers, blow->blower))
    return failure(Code::invalid, "the scene has no blower of this name", "/blower");
  if (const auto* attract = std::get_if<Attract>(&command); attract && missing(settings.attractors, attract->attractor))
    return failure(Code::invalid, "the scene has no attractor of this name", "/attractor");
  if (const auto* layer = std::get_if<ChangeEditLayer>(&command)) {
    if (layer->coat && !layer->coat->empty() && !find_coat(settings.coats, *layer->coat))
      return failure(Code::invalid, "the scene has no coat of this name", "/coat");
    return check(*layer, settings.layers);
  }
  if (const auto* coats = std::get_if<SetCoats>(&command)) return check(*coats, settings.coats);
  if (const auto* coat = std::get_if<SetCoat>(&command)) return check(*coat, settings.coats);
  if (Status bad = check_groomed(edit_layer_of(command), settings.layers); !bad.ok()) return bad;
  if (Status bad = check_groomed_coats(coats_of(command), edit_layer_of(command), settings.coats, settings.layers);
      !bad.ok())
    return bad;
  const auto* base = std::get_if<SetSkinTexture>(&command);
  if (base == nullptr || base->picture.empty()) return {};
  return check_skin_texture(base->picture, journal_);
}

/// Makes the step of a command, with the fields that an erase restores. Also checks the revision that a checkpoint
/// names.
Result<Step> Scene::with_baseline(Command command, const Past& past) const {
  Step step{std::move(command), nullptr};
  const auto* erase = std::get_if<Erase>(&step.command);
  const auto* checkpoint = std::get_if<Checkpoint>(&step.command);
  if (erase == nullptr && (checkpoint == nullptr || !checkpoint->revision)) return step;
  if (checkpoint != nullptr) {
    const Status there = check_revision(*checkpoint->revision);
    return there.ok() ? Result<Step>(std::move(step)) : there;
  }
  Revision revision = erase->revision.value_or(history_.first_revision());
  if (!erase->checkpoint.empty()) {
    const std::vector<NamedRevision>& known = past.settings.checkpoints;
    const auto named = std::find_if(known.begin(), known.end(),
                                    [&](const NamedRevision& other) { return other.name == erase->checkpoint; });
    if (named == known.end()) return failure(Code::invalid, "the scene has no checkpoint of this name", "/checkpoint");
    revision = named->revision;
  }
  Result<FieldSet> baseline = past.fields_at(revision);
  if (!baseline) return baseline.status();
  step.baseline = std::make_shared<const FieldSet>(std::move(*baseline));
  return step;
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
