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
  std::vector<ListedEntry> listed;
  {
    const std::lock_guard lock(mutex_);
    own = model_, listed = history_.listed_entries();
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

std::shared_ptr<const SceneModel> Scene::model() const {
  const std::lock_guard lock(mutex_);
  return model_;
}

Result<GroomSource> Scene::groom(std::optional<Revision> revision) const {
  const Snapshot now = snapshot();
  if (!revision) return GroomSource{id_, revision, now.revision, now.model, now.fields};
  Result<PastFields> past = past_fields(*revision, "/revision");
  if (!past) return past.status();
  return GroomSource{id_, revision, *revision, past->model, std::make_shared<const FieldSet>(std::move(past->fields))};
}

Result<SceneSummary> Scene::subdivide(const Subdivide& how, std::uint64_t id, const ExecuteOptions& options) {
  const std::lock_guard changing(changing_);
  if (Status refused = admit(options); !refused.ok()) return refused;
  Result<SubdividedScene> subdivided = subdivide_scene(*model_, *fields_, history_.settings().layers, how, id);
  if (!subdivided) return subdivided.status();
  if (options.dry_run || !subdivided->model) return summary();
  const Revision revision = history_.revision() + 1;
  auto settings = std::make_shared<SceneSettings>(history_.settings());
  settings->checkpoints.clear();  // of revisions that are gone
  StoredModel model;
  model.subdivisions = subdivided->model->subdivisions;
  const FieldDelta groom = difference(FieldSet(subdivided->fields.size()), subdivided->fields);
  Beginning finer =
      beginning(subdivided->model, std::move(subdivided->fields), new_history(revision, *settings), picture_);
  Status written = journal_.subdivide_model({id_, name_, std::move(model), revision, groom, settings, options.request});
  if (!written.ok()) return written;
  begin_anew(finer);
  return summary();
}

}  // namespace pelage
