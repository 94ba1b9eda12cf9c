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

/// In a log the message says which step it is about.
Status in_step(Status status, std::size_t step) {
  status.message = "step " + std::to_string(step) + " cannot be carried to another model: " + status.message;
  return status;
}

}  // namespace

Result<std::vector<std::vector<Command>>> Scene::effective_log_for(const SceneModel& other) const {
  std::shared_ptr<const SceneModel> own;
  std::vector<std::vector<Command>> steps;
  {
    const std::lock_guard lock(mutex_);
    own = model_, steps = history_.effective_log();
  }
  for (std::size_t k = 0; k < steps.size(); ++k) {
    for (Command& command : steps[k]) {
      Result<Command> carried = carried_command(command, own->surface, other.surface);
      if (!carried) return in_step(carried.status(), k + 1);
      command = std::move(*carried);
    }
  }
  return steps;
}

std::shared_ptr<const SceneModel> Scene::model() const {
  const std::lock_guard lock(mutex_);
  return model_;
}

Result<GroomSource> Scene::groom(std::optional<Revision> revision) const {
  const std::lock_guard lock(mutex_);
  Result<FieldSet> fields = fields_at(revision.value_or(history_.revision()));
  if (!fields) return fields.status();
  return GroomSource{id_, revision, revision.value_or(history_.revision()), model_,
                     std::make_shared<const FieldSet>(std::move(*fields))};
}

Result<SceneSummary> Scene::subdivide(const Subdivide& how, std::uint64_t id, const ExecuteOptions& options) {
  const std::lock_guard lock(mutex_);
  if (Status refused = admit(options); !refused.ok()) return refused;
  Result<SubdividedScene> subdivided = subdivide_scene(*model_, fields_, history_.settings().layers, how, id);
  if (!subdivided) return subdivided.status();
  if (options.dry_run || !subdivided->model) return describe();
  const Revision revision = history_.revision() + 1;
  auto settings = std::make_shared<SceneSettings>(history_.settings());
  settings->checkpoints.clear();  // of revisions that are gone
  StoredModel model;
  model.subdivisions = subdivided->model->subdivisions;
  const FieldDelta groom = difference(FieldSet(subdivided->fields.size()), subdivided->fields);
  Status written = journal_.subdivide_model({id_, name_, std::move(model), revision, groom, settings});
  if (!written.ok()) return written;
  model_ = std::move(subdivided->model);
  copy_id_ = model_->id;
  pose_.reset();
  fields_ = std::move(subdivided->fields);
  history_ = new_history(revision, *settings);
  live_.end();
  dirty_ = {{0, static_cast<std::uint32_t>(fields_.size())}};
  announce();
  return describe();
}

}  // namespace pelage
