// What a scene gives to other models, and takes from itself on a finer one.
#include <memory>
#include <string>
#include <utility>

#include "server/groom/evaluate.h"
#include "server/history/journal.h"
#include "server/scene/model.h"
#include "server/scene/scene.h"

namespace pelage {

namespace {

/// Adds to the message of a refusal which step of a log it is about.
Status in_step(Status status, std::size_t step) {
  status.message = "step " + std::to_string(step) + " cannot be carried to another model: " + status.message;
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
      Result<Command> carried = carried_command(command, own->surface, other.surface);
      if (!carried) return in_step(carried.status(), k + 1);
      command = std::move(*carried);
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
  settings->checkpoints.clear();  // of revisions that are gone
  StoredScene stored{id_, name_, {}, now.revision + 1, {}, settings, options.request};
  stored.model.subdivisions = finer->model->subdivisions;
  stored.first_groom = difference(FieldSet(finer->fields.size()), finer->fields);
  History history = new_history(stored.first_revision, *settings);
  SnapshotPtr fresh = beginning(finer->model, std::move(finer->fields), history, now.skin_texture);
  Status begun = begin_anew(fresh, history, [&] { return journal_.subdivide_model(stored); });
  return begun.ok() ? Result<SceneSummary>(summary()) : begun;
}

}  // namespace pelage
