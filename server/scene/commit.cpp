// How a change comes into a scene: whole or not at all.
#include <span>
#include <utility>

#include "server/history/journal.h"
#include "server/import/import.h"
#include "server/scene/scene.h"

namespace pelage {

namespace {

constexpr std::size_t many_ranges = 1 << 12;  // when nobody draws, ranges are merged now and then

std::vector<VertexRange> changed_ranges(std::span<const Entry> entries) {
  std::vector<VertexRange> changed;
  for (const Entry& entry : entries) {
    const std::vector<VertexRange> more = entry.delta.dirty_ranges();
    changed.insert(changed.end(), more.begin(), more.end());
  }
  return changed;
}

void make_room(std::vector<VertexRange>& dirty, std::size_t more) {
  if (dirty.size() > many_ranges) dirty = merge_ranges(dirty);
  dirty.reserve(dirty.size() + more);
}

/// Adds the ranges `more` to `dirty`. If a reader has taken the ranges and their storage meanwhile, `more` replaces
/// them.
void add_ranges(std::vector<VertexRange>& dirty, std::vector<VertexRange>& more, std::size_t vertices) noexcept {
  if (dirty.empty()) return dirty.swap(more);
  if (dirty.capacity() - dirty.size() >= more.size())
    dirty.insert(dirty.end(), more.begin(), more.end());
  else
    dirty.assign(1, {0, static_cast<std::uint32_t>(vertices)});
}

}  // namespace

/// Commits entries that lead to `fields` and to `live`. Everything that can fail is done before the journal has the
/// entries, and is prepared beside the scene; what follows only moves it in, so that the scene and the journal never
/// differ. Readers wait only for that move.
Status Scene::commit(std::span<const Entry> entries, FieldSet fields, LiveStroke live) {
  auto after = std::make_shared<const FieldSet>(std::move(fields));
  std::vector<VertexRange> changed = changed_ranges(entries);
  History::Prepared prepared = history_.prepare(entries);
  Result<LaidPicture> picture = picture_of(prepared.settings(), picture_);
  if (!picture) return picture.status();
  {
    const std::lock_guard lock(mutex_);
    history_.reserve(entries.size());
    make_room(dirty_, changed.size());
  }
  if (Status written = journal_.append(id_, entries); !written.ok()) return written;
  const std::lock_guard lock(mutex_);
  fields_.swap(after);  // which is freed without the lock
  history_.record(std::move(prepared));
  live_ = std::move(live);
  picture_ = std::move(*picture);
  add_ranges(dirty_, changed, fields_->size());
  announce();
  return {};
}

/// The journal keeps the pictures that logs name, so that undo and redo find them.
Result<Scene::LaidPicture> Scene::picture_of(const SceneSettings& settings, const LaidPicture& present) const {
  const std::string& name = settings.skin_texture;
  if (name == present.name) return present;
  if (name.empty()) return LaidPicture{};
  const Result<std::string> bytes = journal_.picture(name);
  if (!bytes) return bytes.status();
  Result<RawImage> image = decode_raw_image(std::as_bytes(std::span(*bytes)));
  if (!image) return failure(Code::internal, "the journal is damaged: a picture cannot be read");
  return LaidPicture{std::make_shared<const RawImage>(std::move(*image)), name};
}

/// All that it takes is allocated before the journal has the model.
Scene::Beginning Scene::beginning(std::shared_ptr<const SceneModel> model, FieldSet fields, History history,
                                  LaidPicture picture) {
  const auto vertices = static_cast<std::uint32_t>(fields.size());
  return {std::move(model),
          std::make_shared<const FieldSet>(std::move(fields)),
          std::move(history),
          std::move(picture),
          {{0, vertices}}};
}

/// Makes `beginning` the state of the scene and moves the previous state into `beginning`, to be freed without the
/// lock.
void Scene::begin_anew(Beginning& beginning) noexcept {
  const std::lock_guard lock(mutex_);
  if (model_ != beginning.model) copy_id_ = beginning.model->id, pose_.reset();
  model_.swap(beginning.model);
  fields_.swap(beginning.fields);
  std::swap(history_, beginning.history);
  std::swap(picture_, beginning.picture);
  dirty_.swap(beginning.dirty);
  live_.end();
  announce();
}

/// Publishes the newest revision and wakes those who wait for it.
void Scene::announce() noexcept {
  newest_ = history_.revision();
  changed_.notify_all();
}

}  // namespace pelage
