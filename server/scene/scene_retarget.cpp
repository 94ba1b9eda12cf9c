// Transfers a scene's groom: to other scenes, and to a new, subdivided or rotated model of the same scene.
#include <memory>
#include <string>
#include <utility>

#include "server/fields/field_mix.h"
#include "server/groom/evaluate.h"
#include "server/groom/first_groom.h"
#include "server/history/journal.h"
#include "server/scene/creature_settings.h"
#include "server/scene/model.h"
#include "server/scene/moving_model.h"
#include "server/scene/new_version.h"
#include "server/scene/scene.h"

namespace pelage {

namespace {

/// Adds the number of the log's step to the message of an error.
Status in_step(Status status, std::size_t step) {
  status.message = "step " + std::to_string(step) + " cannot be transferred to another model: " + status.message;
  return status;
}

}  // namespace

Result<std::vector<std::vector<Command>>> Scene::effective_log_for(const SceneModel& other) const {
  std::shared_ptr<const SceneModel> own;
  std::vector<ListedEntry> listed;
  {
    const std::lock_guard lock(mutex_);
    own = present_->model, listed = history_.listed_entries();
  }
  std::vector<std::vector<Command>> steps = commands_of(listed);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    for (Command& command : steps[k]) {
      Result<Command> transferred = transferred_command(command, own->surface, other.surface);
      if (!transferred) return in_step(transferred.status(), k + 1);
      command = std::move(*transferred);
    }
  }
  return steps;
}

std::shared_ptr<const SceneModel> Scene::model() const { return snapshot()->model; }

Result<GroomSource> Scene::groom(std::optional<Revision> revision) const {
  const SnapshotPtr now = snapshot();
  const Result<SceneSnapshot> asked = revision ? snapshot_at(*revision) : *now;
  if (!asked) return asked.status();
  return GroomSource{id_, revision, asked->revision, asked->model, asked->fields};
}

Result<SceneSummary> Scene::subdivide(const Subdivide& how, std::uint64_t id, const ExecuteOptions& options) {
  const Result<ChangeTurns::Turn> turn = begin_change(options);
  if (!turn) return turn.status();
  const SceneSnapshot& now = *present_;
  Result<SubdividedScene> finer = subdivide_scene(*now.model, *now.fields, now.settings->layers, how, id);
  if (!finer) return finer.status();
  if (options.dry_run || !finer->model) return summary();
  auto settings = std::make_shared<SceneSettings>(*now.settings);
  settings->checkpoints.clear();  // their revisions are gone
  StoredScene stored{id_, name_, {}, now.revision + 1, {}, settings, options.request};
  const ModelReport& report = now.model->surface.mesh().report;
  stored.model.subdivisions = finer->model->subdivisions;
  stored.model.prepare.up = report.up, stored.model.prepare.front = report.front;
  stored.first_groom = difference(FieldSet(finer->fields.size()), finer->fields);
  return restart_with(stored, finer->model, std::move(finer->fields), now.skin_texture, &Journal::reshape_model);
}

namespace {

/// Returns the preparation with the file axes that point up and forward after the model has been rotated.
PrepareOptions turned_axes(PrepareOptions stored, const TurnModel& how) {
  const glm::dmat3 turn = axes_rotation(how.up, how.front) * axes_rotation(stored.up, stored.front);
  stored.up = axis_mapped_to(turn, Axis::plus_y), stored.front = axis_mapped_to(turn, Axis::plus_z);
  return stored;
}

SceneSettings turned_settings(const SceneSettings& settings, const Surface& before, const Mesh& after,
                              const glm::dmat3& turn) {
  const std::vector<glm::dmat3> rotations(after.positions.size(), turn);
  SceneSettings rotated = moved_with_surface(settings, before, after, rotations);
  for (Eye& eye : rotated.eyes)
    if (eye.look_at) eye.look_at = turn * *eye.look_at;
  rotated.checkpoints.clear();  // their revisions are gone
  return rotated;
}

}  // namespace

Result<SceneSummary> Scene::turn(const TurnModel& how, std::uint64_t id, const ExecuteOptions& options) {
  if (how.up == how.front || glm::determinant(axes_rotation(how.up, how.front)) == 0)
    return failure(Code::invalid, "up and front lie on the same axis.", "/front", "another axis than up");
  const Result<ChangeTurns::Turn> in_turn = begin_change(options);
  if (!in_turn) return in_turn.status();
  const bool stands = how.up == Axis::plus_y && how.front == Axis::plus_z;
  if (options.dry_run || stands) return summary();
  const SceneSnapshot& now = *present_;
  Result<StoredScene> stored = journal_.scene(id_);
  if (!stored) return stored.status();
  const Result<RawModel> raw = decode_raw_model(std::as_bytes(std::span(stored->model.raw)));
  if (!raw) return raw.status();
  stored->model.prepare = turned_axes(stored->model.prepare, how);
  stored->model.subdivisions.push_back({});
  const auto model = build_model(*raw, stored->model, id);
  if (!model) return model.status();

  const Surface& before = now.model->surface;
  const Mesh& after = (*model)->surface.mesh();
  const glm::dmat3 turn = axes_rotation(how.up, how.front);
  FieldSet fields = rotated(*now.fields, before.mesh(), after, turn, now.settings->layers);
  const auto settings = std::make_shared<const SceneSettings>(turned_settings(*now.settings, before, after, turn));
  stored->first_revision = now.revision + 1, stored->first_settings = settings, stored->request = options.request;
  stored->first_groom = difference(FieldSet(fields.size()), fields);
  return restart_with(*stored, *model, std::move(fields), now.skin_texture, &Journal::reshape_model);
}

Result<SceneSummary> Scene::replace_model(const std::shared_ptr<const SceneModel>& model, FirstGroom fur,
                                          StoredModel stored, bool ground, const ExecuteOptions& options) {
  FieldSet fields = first_groom(model->surface.mesh(), fur, options.cancel);
  const Result<ChangeTurns::Turn> turn = begin_change(options);
  if (!turn) return turn.status();
  if (options.dry_run) return summary();
  const auto settings = std::make_shared<const SceneSettings>(first_settings(*model, ground));
  const StoredScene scene{
      id_, name_, std::move(stored), present_->revision + 1, difference(FieldSet(fields.size()), fields), settings, {}};
  return restart_with(scene, model, std::move(fields), nullptr, &Journal::replace_model);
}

Result<SceneSummary> Scene::transfer_groom_to(const std::shared_ptr<const SceneModel>& model, StoredModel stored,
                                              const ExecuteOptions& options) {
  const Result<ChangeTurns::Turn> turn = begin_change(options);
  if (!turn) return turn.status();
  const SceneSnapshot& now = *present_;
  TransferredGroom groom = transferred_groom(now, *model);
  const auto settings = std::make_shared<const SceneSettings>(std::move(groom.settings));
  const auto texture = settings->skin_texture.empty() ? nullptr : now.skin_texture;
  const StoredScene scene{
      id_,      name_, std::move(stored), now.revision + 1, difference(FieldSet(groom.fields.size()), groom.fields),
      settings, {}};
  Result<SceneSummary> summary = restart_with(scene, model, std::move(groom.fields), texture, &Journal::replace_model);
  if (summary) summary->transfer = groom.report;
  return summary;
}

/// Restarts the scene with an empty log, as `stored` says; `write` puts that into the journal.
Result<SceneSummary> Scene::restart_with(const StoredScene& stored, const std::shared_ptr<const SceneModel>& model,
                                         FieldSet fields, std::shared_ptr<const RawImage> skin_texture,
                                         Status (Journal::*write)(const StoredScene&)) {
  History history = new_history(stored.first_revision, *stored.first_settings);
  SnapshotPtr fresh = first_snapshot(model, std::move(fields), history, std::move(skin_texture));
  Status begun = replace_state(fresh, history, [&] { return (journal_.*write)(stored); });
  return begun.ok() ? Result<SceneSummary>(summary()) : begun;
}

}  // namespace pelage
