#include "server/scene/scene_store.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <random>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "protocol/json/names.h"
#include "server/import/import.h"
#include "server/scene/creature_settings.h"
#include "server/scene/foreign_scene.h"
#include "server/scene/imported_model.h"
#include "server/scene/model.h"
#include "server/scene/scene_store_impl.h"

namespace pelage {

namespace {

/// Returns 12 random hex digits.
std::string random_id() {
  static constexpr char digits[] = "0123456789abcdef";
  std::random_device device;
  std::string id(12, '0');
  for (char& c : id) c = digits[device() & 15];
  return id;
}

Status no_such_source() {
  return failure(Code::invalid, "the server has no such scene to take fields from", "/scene",
                 "the id of a scene of this server, not its name");
}

FieldDelta groom_of(const Scene& scene) {
  const SnapshotPtr now = scene.snapshot();
  return difference(FieldSet(now->fields->size()), *now->fields);
}

}  // namespace

Result<std::shared_ptr<const SceneModel>> SceneStore::Impl::model_of(const StoredScene& stored) {
  const Result<RawModel> raw = decode_raw_model(std::as_bytes(std::span(stored.model.raw)));
  if (!raw) return raw.status();
  return build_model(*raw, stored.model, ++last_model);
}

Result<SceneStore::Impl::Restored> SceneStore::Impl::restored(const std::string& id) {
  const Result<StoredScene> stored = journal->scene(id);
  if (!stored) return stored.status();
  auto model = model_of(*stored);
  if (!model) return model.status();
  auto scene = std::make_shared<Scene>(id, stored->name, *model, FirstGroom{}, *journal, undo_bytes);
  return std::pair(scene, scene->restore(stored->first_groom, stored->first_revision, stored->first_settings));
}

/// Opens a scene. A damaged one does not affect others: the server serves its intact part and refuses changes to it.
Result<std::shared_ptr<Scene>> SceneStore::Impl::opened(const std::string& id) {
  const Result<Restored> restored = this->restored(id);
  if (!restored) return failure(Code::conflict, "the scene cannot be opened: " + restored.status().message);
  const auto& [scene, damage] = *restored;
  if (!damage.ok()) scene->quarantine(damage.message);
  return scene;
}

Result<std::shared_ptr<Scene>> SceneStore::Impl::add(StoredScene stored, std::shared_ptr<const SceneModel> model,
                                                     FirstGroom fur) {
  auto scene = std::make_shared<Scene>(stored.id, stored.name, std::move(model), fur, *journal, undo_bytes,
                                       stored.first_settings.get());
  stored.first_groom = groom_of(*scene);
  if (Status added = scenes.add(scene, [&] { return journal->add_scene(stored); }); !added.ok()) return added;
  return scene;
}

Result<MovingModel> SceneStore::moving_model(const Scene& scene) const {
  const Result<StoredScene> stored = impl_->journal->scene(scene.id());
  if (!stored) return stored.status();
  return MovingModel::create(stored->model, scene.model());
}

std::uint64_t SceneStore::new_model_id() const { return ++impl_->last_model; }

SceneStore::SceneStore(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SceneStore::~SceneStore() = default;

Result<std::unique_ptr<SceneStore>> SceneStore::open(const std::string& data_folder, const std::string& worker,
                                                     std::size_t undo_bytes, std::size_t memory) {
  std::error_code error;
  std::filesystem::create_directories(data_folder, error);
  if (error) return failure(Code::internal, "the data folder cannot be made: " + error.message());
  auto journal = Journal::open_guarded((std::filesystem::path(data_folder) / "pelage.sqlite").string());
  if (!journal) return journal.status();
  auto impl = std::make_unique<Impl>(memory);
  impl->journal = std::move(*journal);
  impl->worker = worker;
  impl->undo_bytes = undo_bytes;
  const Result<std::vector<std::string>> ids = impl->journal->scene_ids();
  if (!ids) return ids.status();
  for (const std::string& id : *ids) {
    const Result<std::shared_ptr<Scene>> scene = impl->opened(id);
    if (!scene) {
      const Result<std::string> name = impl->journal->name_of(id);
      SceneSummary summary;
      summary.id = id, summary.name = name ? *name : "", summary.damage = scene.status().message;
      impl->scenes.add_damaged(summary);
    } else if (Status added = impl->scenes.add(*scene); !added.ok()) {
      return failure(Code::internal, "scene " + id + " cannot be restored: " + added.message);
    }
  }
  return std::unique_ptr<SceneStore>(new SceneStore(std::move(impl)));
}

Result<std::shared_ptr<Scene>> SceneStore::create(const NewScene& request, const std::optional<KeyedRequest>& keyed) {
  if (Status full = impl_->scenes.check_scene_limit(); !full.ok()) return full;
  const std::shared_ptr<const RawModel> raw = impl_->builtins.model(request.model);
  StoredModel how{.name = json_names::word_of(json_names::builtins, request.model.shape),
                  .raw = encode_raw_model(*raw),
                  .fur_patches = request.fur_patches};
  auto model = build_model(*raw, how, ++impl_->last_model);
  if (!model) return model.status();
  auto settings = std::make_shared<const SceneSettings>(first_settings(**model, request.ground));
  return impl_->add({random_id(), request.name, std::move(how), 0, {}, std::move(settings), keyed}, *model,
                    request.fur);
}

Result<std::shared_ptr<Scene>> SceneStore::branch(const Scene& from, const BranchRequest& request,
                                                  const std::optional<KeyedRequest>& keyed) {
  if (Status full = impl_->scenes.check_scene_limit(); !full.ok()) return full;
  Result<std::shared_ptr<Scene>> scene =
      from.branch(random_id(), request.name, request.revision, ++impl_->last_model, keyed);
  if (!scene) return scene;
  Status added = impl_->scenes.add(*scene);
  if (added.ok()) return scene;
  const Status removed = (*scene)->remove();  // the limit was reached by other scenes meanwhile
  return removed.ok() ? added : removed;
}

Result<Revision> SceneStore::save(const Scene& scene, const std::string& path, const Cancel& cancel) const try {
  const auto file = Journal::open(path);
  if (!file) return file.status();
  const SceneSummary summary = scene.summary();
  return impl_->journal->copy_scene(scene.id(), summary.revision, **file, scene.id(), summary.name,
                                    [&] { cancel.check(); });
} catch (const Cancelled&) {
  return nobody_waits();
}

namespace {

constexpr const char* exported = "a file that was exported as pelage";

/// Returns the error for a file whose rows are no valid scene, with the reason of `status`.
Status not_saved(const Status& status) {
  return failure(Code::invalid, "The file cannot be opened: " + status.message, "", exported);
}

Status with_limit(Status status, const char* limit) {
  status.limit = limit;
  return status;
}

/// Returns the scene of a file that must hold exactly one.
Result<StoredScene> only_scene(const Journal& file) {
  const Result<std::vector<std::string>> ids = file.scene_ids();
  if (!ids) return ids.status();
  if (ids->size() != 1)
    return failure(Code::invalid, "it holds " + std::to_string(ids->size()) + " scenes, and not one");
  return file.scene(ids->front());
}

}  // namespace

Result<std::shared_ptr<Scene>> SceneStore::open_saved(std::span<const std::byte> bytes, const std::string& scratch,
                                                      const std::string& name, const Cancel& cancel) try {
  if (Status full = impl_->scenes.check_scene_limit(); !full.ok()) return full;
  const auto file = Journal::from_rows(scratch, [&](const Journal::TakeRows& take) {
    return import_saved(impl_->worker, bytes, take, cancellable_limits(cancel));
  });
  if (!file) return file.status().code == Code::invalid ? with_limit(file.status(), exported) : file.status();
  const Result<StoredScene> stored = only_scene(**file);
  if (!stored) return not_saved(stored.status());
  const auto named = decode_branch(encode(BranchRequest{.name = name.empty() ? stored->name : name}));
  if (!named) return not_saved(named.status());
  const auto model = impl_->model_of(*stored);
  if (!model) return not_saved(model.status());
  if (Status bad = check_foreign(**file, *stored, **model); !bad.ok()) return not_saved(bad);
  const std::string id = random_id();
  const Result<Revision> copied =
      (*file)->copy_scene(stored->id, newest_revision, *impl_->journal, id, named->name, [&] { cancel.check(); });
  if (!copied) return copied.status();
  const Result<Impl::Restored> restored = impl_->restored(id);
  const Status intact = restored ? restored->second : restored.status();
  const Status added = intact.ok() ? impl_->scenes.add(restored->first) : intact;
  if (added.ok()) return restored->first;
  static_cast<void>(impl_->journal->remove_scene(id));  // the earlier error is the one to report
  return added;
} catch (const Cancelled&) {
  return nobody_waits();
}

Result<std::shared_ptr<Scene>> SceneStore::find(const std::string& id) const { return impl_->scenes.find(id); }

Status SceneStore::remove(const std::string& id) {
  return impl_->scenes.remove(id, [&](const std::string& evicted) { return impl_->journal->remove_scene(evicted); });
}

Status SceneStore::health() const { return impl_->journal->health(); }

std::vector<std::string> SceneStore::damages() const {
  std::vector<std::string> damages;
  for (const LostEntries& lost : impl_->journal->lost()) {
    damages.push_back("scene " + lost.scene + " was at revision " + std::to_string(lost.acknowledged) + " and is " +
                      (lost.present ? "at revision " + std::to_string(*lost.present) : "gone") +
                      ": the end of the journal is lost");
  }
  for (const SceneSummary& scene : list()) {
    if (!scene.damage.empty()) damages.push_back("scene " + scene.id + ": " + scene.damage);
  }
  return damages;
}

Result<std::optional<RequestedChange>> SceneStore::change_of_request(const KeyedRequest& request) const {
  return impl_->journal->change_of_request(request.path, request.key);
}

std::size_t SceneStore::count() const { return impl_->scenes.count(); }

std::vector<SceneSummary> SceneStore::list() const { return impl_->scenes.list(); }

MemoryUse SceneStore::memory() const { return impl_->scenes.memory(); }

void SceneStore::on_close(OpenScenes::OnClose forget) { impl_->scenes.on_close(std::move(forget)); }
void SceneStore::count_coats(std::function<std::size_t()> coat_bytes) {
  impl_->scenes.count_coats(std::move(coat_bytes));
}
void SceneStore::count_copies(OpenScenes::CopyBytes copy_bytes) { impl_->scenes.count_copies(std::move(copy_bytes)); }

Result<SceneSummary> SceneStore::subdivide(Scene& scene, const Subdivide& how, const ExecuteOptions& execute) {
  return scene.subdivide(how, ++impl_->last_model, execute);
}

Result<SceneSummary> SceneStore::turn(Scene& scene, const TurnModel& how, const ExecuteOptions& execute) {
  return scene.turn(how, ++impl_->last_model, execute);
}

Result<std::vector<GroomSource>> SceneStore::sources_of(const std::vector<Command>& commands) const {
  std::vector<GroomSource> sources;
  for (std::size_t k = 0; k < commands.size(); ++k) {
    const auto* retarget = std::get_if<Retarget>(&commands[k]);
    if (retarget == nullptr) continue;
    const Result<std::shared_ptr<Scene>> scene = find(retarget->scene);
    Result<GroomSource> groom = scene ? (*scene)->groom(retarget->revision) : no_such_source();
    if (!groom) return in_batch(groom.status(), k, commands.size());
    sources.push_back(std::move(*groom));
  }
  return sources;
}

Result<CommandAnswer> SceneStore::amend(Scene& scene, const AmendRequest& request, ExecuteOptions options) const {
  Result<std::vector<GroomSource>> sources = sources_of(request.commands);
  if (!sources) return sources.status();
  options.sources = std::move(*sources);
  // A missing source of a logged retarget is an error only if that step has to be replayed.
  for (const std::vector<Command>& step : scene.effective_log()) {
    for (const Command& command : step) {
      Result<std::vector<GroomSource>> logged = sources_of({command});
      if (logged) std::move(logged->begin(), logged->end(), std::back_inserter(options.sources));
    }
  }
  return scene.amend(request, options);
}

Result<CommandAnswer> SceneStore::execute(Scene& scene, const std::vector<Command>& commands,
                                          ExecuteOptions options) const {
  Result<std::vector<GroomSource>> sources = sources_of(commands);
  if (!sources) return sources.status();
  options.sources = std::move(*sources);
  return scene.execute(commands, options);
}

}  // namespace pelage
