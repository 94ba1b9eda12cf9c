// Commits changes to a scene atomically: to the journal, then to memory.
#include <span>
#include <utility>

#include "server/history/journal.h"
#include "server/import/import.h"
#include "server/scene/scene.h"

namespace pelage {

namespace {

std::vector<VertexRange> changed_ranges(std::span<const Entry> entries) {
  std::vector<VertexRange> changed;
  for (const Entry& entry : entries) {
    const std::vector<VertexRange> more = entry.delta.dirty_ranges();
    changed.insert(changed.end(), more.begin(), more.end());
  }
  return changed;
}

}  // namespace

Status Scene::take_over(const std::function<Status()>& write, const std::function<void()>& publish) {
  const std::lock_guard writing(writing_);
  if (Status removed = gone(); !removed.ok()) return removed;
  if (Status written = write(); !written.ok()) return written;
  const std::lock_guard lock(mutex_);
  publish();
  publish_revision();
  return {};
}

/// Commits entries that lead to `fields` and to `live`. Everything that can fail happens before the journal has the
/// entries, and the new state is prepared separately; what follows only moves it in, so that scene and journal never
/// differ. Readers wait only for that move.
Status Scene::commit(std::span<const Entry> entries, FieldSet fields, LiveStroke live) {
  History::Prepared prepared = history_.prepare(entries);
  auto texture = skin_texture_of(*prepared.settings(), present_.get());
  if (!texture) return texture.status();
  auto after = std::make_shared<SceneSnapshot>(*present_);
  after->fields = std::make_shared<const FieldSet>(std::move(fields));
  after->settings = prepared.settings();
  after->revision = entries.back().revision;
  after->skin_texture = std::move(*texture);
  after->changes = present_->changes.with(changed_ranges(entries));
  SnapshotPtr next = std::move(after);  // holds the old snapshot after the swap, so that it is freed without the lock
  {
    const std::lock_guard lock(mutex_);
    history_.reserve(entries.size());
  }
  return take_over([&] { return journal_.append(id_, entries); },
                   [&] {
                     present_.swap(next);
                     history_.record(std::move(prepared));
                     live_ = std::move(live);
                   });
}

/// Returns the skin texture that the settings name. The journal keeps all pictures that logs name, so that undo and
/// redo find them.
Result<std::shared_ptr<const RawImage>> Scene::skin_texture_of(const SceneSettings& settings,
                                                               const SceneSnapshot* present) const {
  const std::string& name = settings.skin_texture;
  if (present != nullptr && name == present->settings->skin_texture) return present->skin_texture;
  if (name.empty()) return std::shared_ptr<const RawImage>();
  const Result<std::string> bytes = journal_.picture(name);
  if (!bytes) return bytes.status();
  Result<RawImage> image = decode_raw_image(std::as_bytes(std::span(*bytes)));
  if (!image) return failure(Code::internal, "the journal is damaged: a picture cannot be read");
  return std::make_shared<const RawImage>(std::move(*image));
}

SnapshotPtr Scene::first_snapshot(std::shared_ptr<const SceneModel> model, FieldSet fields, const History& history,
                                  std::shared_ptr<const RawImage> skin_texture) const {
  auto begun = std::make_shared<SceneSnapshot>();
  const bool same = present_ && present_->model == model;
  begun->copy_id = same ? present_->copy_id : model->id;
  if (same) begun->pose = present_->pose;
  begun->changes = (same ? present_->changes : RecentChanges()).with(full_vertex_range(fields.size()));
  begun->model = std::move(model);
  begun->fields = std::make_shared<const FieldSet>(std::move(fields));
  begun->settings = history.settings_at(history.revision());
  begun->revision = history.revision();
  begun->skin_texture = std::move(skin_texture);
  return begun;
}

/// Swaps a new initial state into the scene. Both arguments then hold the old state, to be freed without the lock.
Status Scene::replace_state(SnapshotPtr& snapshot, History& history, const std::function<Status()>& write) {
  return take_over(write, [&] {
    present_.swap(snapshot);
    std::swap(history_, history);
    live_.end();
  });
}

/// Publishes the newest revision and wakes the threads that wait for it.
void Scene::publish_revision() noexcept {
  newest_ = present_->revision;
  changed_.notify_all();
}

}  // namespace pelage
