// A scene's past beside its present: branches, and the fields of an earlier revision.
#include "server/history/journal.h"
#include "server/scene/scene.h"

namespace pelage {

Result<std::shared_ptr<Scene>> Scene::branch(const std::string& id, const std::string& name,
                                             std::optional<Revision> at, std::uint64_t copy_id) const {
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
  Status restored = stored ? scene->restore(stored->first_groom, stored->first_revision, stored->first_settings) : stored.status();
  if (restored.ok()) return scene;
  scene->remove();
  return restored;
}

Result<PastFields> Scene::past_fields(Revision revision) const {
  std::unique_lock lock(mutex_);
  if (Status bad = check_revision(revision, "/overlay_from"); !bad.ok()) return bad;
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
  if (Status bad = check_revision(revision, "/overlay_from"); !bad.ok()) return bad;
  return read.ok() ? failure(Code::internal, "the journal is damaged: an entry does not fit the ones before it") : read;
}

}  // namespace pelage
