// How a change comes into a scene: whole or not at all.
#include <new>
#include <span>
#include <utility>

#include "server/history/journal.h"
#include "server/import/import.h"
#include "server/scene/scene.h"

namespace pelage {

namespace {

constexpr std::size_t many_ranges = 1 << 12;  // when nobody draws, ranges are merged now and then

std::vector<VertexRange> with_changes(std::vector<VertexRange> dirty, std::span<const Entry> entries) {
  for (const Entry& entry : entries) {
    const std::vector<VertexRange> more = entry.delta.dirty_ranges();
    dirty.insert(dirty.end(), more.begin(), more.end());
  }
  return dirty.size() > many_ranges ? merge_ranges(std::move(dirty)) : dirty;
}

}  // namespace

/// Entries lead to `fields` and to `live`. All that can fail comes before the journal has the entries and is put beside
/// the scene; what comes after only moves it in, so that the scene and the journal never differ.
Status Scene::commit(std::span<const Entry> entries, FieldSet fields, LiveStroke live) {
  History::Prepared prepared = history_.prepare(entries);
  Result<LaidPicture> picture = picture_of(prepared.settings());
  if (!picture) return picture.status();
  std::vector<VertexRange> dirty = with_changes(dirty_, entries);
  SceneSummary summary = describe();
  summary.edit_layers = prepared.settings().layers;
  if (Status written = journal_.append(id_, entries); !written.ok()) return written;
  fields_ = std::move(fields);
  history_.record(std::move(prepared));
  live_ = std::move(live);
  picture_ = std::move(*picture);
  dirty_ = std::move(dirty);
  publish(std::move(summary));
  return {};
}

/// The journal keeps the pictures that logs name, so that undo and redo find them.
Result<Scene::LaidPicture> Scene::picture_of(const SceneSettings& settings) const {
  const std::string& name = settings.skin_texture;
  if (name == picture_.name) return picture_;
  if (name.empty()) return LaidPicture{};
  const Result<std::string> bytes = journal_.picture(name);
  if (!bytes) return bytes.status();
  Result<RawImage> image = decode_raw_image(std::as_bytes(std::span(*bytes)));
  if (!image) return failure(Code::internal, "the journal is damaged: a picture cannot be read");
  return LaidPicture{std::make_shared<const RawImage>(std::move(*image)), name};
}

/// To those who wait, and to those who look without the lock. `summary` has all of the scene but for its numbers.
void Scene::publish(SceneSummary&& summary) noexcept {
  newest_ = summary.revision = history_.revision();
  summary.fields_hash = fields_.hash();
  summary.undo_steps = history_.undo_steps();
  summary.redo_steps = history_.redo_steps();
  const SceneMemory memory = measure_memory();
  {
    const std::lock_guard lock(published_mutex_);
    published_ = std::move(summary);
    memory_ = memory;
  }
  changed_.notify_all();
}

/// Where memory does not do for a summary, lists show the one before: the change itself is done and stays.
void Scene::announce() noexcept try { publish(describe()); } catch (const std::bad_alloc&) {
  newest_ = history_.revision();
  changed_.notify_all();
}

}  // namespace pelage
