// A scene's past beside its present: branches, the fields of an earlier revision, and what has changed since.
#include <string>
#include <utility>

#include "server/history/journal.h"
#include "server/scene/scene.h"

namespace pelage {

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
  return read.ok() ? damaged_journal() : read;
}

}  // namespace pelage
