#include "server/scene/open_scenes.h"

#include <algorithm>
#include <map>
#include <utility>

#include "base/caught.h"
#include "base/limits.h"

namespace pelage {

namespace {

Status no_such_scene() { return failure(Code::not_found, "there is no such scene"); }

/// `conflict`, not `busy`: clients wait and retry if a server is busy, and waiting does not help here.
Status too_many() {
  return failure(Code::conflict, "there are as many scenes as the server holds; remove one first", {},
                 "at most " + std::to_string(limits::scenes) + " scenes");
}

}  // namespace

OpenScenes::Slot* OpenScenes::slot_of(const std::string& id) {
  const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) { return slot.id == id; });
  return found == slots_.end() ? nullptr : &*found;
}

/// A model shared by branches counts once; the renderer's copy of each branch counts separately.
std::size_t OpenScenes::open_bytes() const {
  std::map<std::uint64_t, std::size_t> models;
  std::size_t bytes = copies_bytes();
  for (const Slot& slot : slots_) {
    if (!slot.scene) continue;
    const SceneMemory memory = slot.scene->memory();
    bytes += memory.own;
    models[memory.model_id] = memory.model;
  }
  for (const auto& [id, model] : models) bytes += model;
  return bytes;
}

std::size_t OpenScenes::copies_bytes() const {
  std::size_t bytes = 0;
  for (const Slot& slot : slots_) {
    if (slot.scene && copy_bytes_) bytes += copy_bytes_(slot.scene->memory().copy_id);
  }
  return bytes;
}

/// Returns the scene to evict next, or null. A scene referenced only by its slot cannot gain a user while the lock is
/// held. The scene that was used last stays, since somebody works on it. Scenes in the middle of a stroke are evicted
/// last, because the journal does not know that the stroke continues.
OpenScenes::Slot* OpenScenes::next_to_evict() {
  Slot* next = nullptr;
  bool next_in_stroke = false;
  for (Slot& slot : slots_) {
    if (!slot.scene || slot.scene.use_count() > 1 || slot.last_use == uses_) continue;
    const bool in_stroke = slot.scene->memory().in_stroke;
    if (next && std::pair(next_in_stroke, next->last_use) < std::pair(in_stroke, slot.last_use)) continue;
    next = &slot, next_in_stroke = in_stroke;
  }
  return next;
}

OpenScenes::Dropped OpenScenes::evict_to_budget() {
  Dropped dropped;
  while (open_bytes() + coats_bytes() > budget_) {
    Slot* slot = next_to_evict();
    if (!slot) break;
    slot->summary = slot->scene->summary();
    dropped.push_back(std::move(slot->scene));
    slot->scene = nullptr;
    ++evictions_;
  }
  return dropped;
}

/// Frees evicted scenes. The caller must not hold the lock.
void OpenScenes::close(Dropped dropped) const {
  if (dropped.empty()) return;
  for (const auto& scene : dropped) {
    if (on_close_) on_close_(scene->memory().copy_id);
  }
  dropped.clear();
  trim_allocator();
}

Status OpenScenes::check_scene_limit() const { return count() < limits::scenes ? Status{} : too_many(); }

Status OpenScenes::add(const std::shared_ptr<Scene>& scene, const std::function<Status()>& write) {
  Slot slot{scene->id(), scene};
  std::unique_lock lock(mutex_);
  if (slots_.size() + adding_ >= limits::scenes) return too_many();
  slots_.reserve(slots_.size() + adding_ + 1);  // allocation must fail before the journal has the scene
  ++adding_;
  lock.unlock();
  Status written;
  try {  // without the lock, because the disk may be slow
    if (write) written = write();
  } catch (...) {
    lock.lock();
    --adding_;
    throw;
  }
  lock.lock();
  --adding_;
  if (!written.ok()) return written;
  slot.last_use = ++uses_;
  slots_.push_back(std::move(slot));
  Dropped dropped = evict_to_budget();
  lock.unlock();
  close(std::move(dropped));
  trim_allocator();  // memory that preparing the model took
  return {};
}

void OpenScenes::add_damaged(const SceneSummary& summary) {
  const std::lock_guard lock(mutex_);
  slots_.push_back({summary.id, nullptr, summary});
}

Result<std::shared_ptr<Scene>> OpenScenes::find(const std::string& id) {
  std::shared_ptr<Scene> scene;
  Dropped dropped;
  {
    std::unique_lock lock(mutex_);
    Slot* slot = slot_of(id);
    while (slot && slot->opening) {
      opened_.wait(lock);
      slot = slot_of(id);
    }
    if (!slot) return no_such_scene();
    slot->last_use = ++uses_;
    scene = slot->scene;
    slot->opening = !scene;
    dropped = evict_to_budget();
  }
  close(std::move(dropped));
  if (scene) return scene;
  return reopen(id);
}

/// Opens an evicted scene again. Its slot has `opening` set, so that no other thread changes it meanwhile.
Result<std::shared_ptr<Scene>> OpenScenes::reopen(const std::string& id) {
  const auto finish = [&](const std::shared_ptr<Scene>& scene, const std::string& damage = {}) {
    const std::lock_guard lock(mutex_);
    Slot& slot = *slot_of(id);
    slot.scene = scene;
    slot.opening = false;
    opened_.notify_all();
    slot.summary.damage = damage;
    if (!scene) return Dropped();
    slot.last_use = ++uses_;
    ++reopened_;
    return evict_to_budget();
  };
  Result<std::shared_ptr<Scene>> scene = failure(Code::internal, "the scene was not opened");
  try {
    scene = open_(id);
  } catch (...) {
    finish(nullptr);
    throw;
  }
  close(scene ? finish(*scene) : finish(nullptr, scene.status().message));
  return scene;
}

Status OpenScenes::remove(const std::string& id, const std::function<Status(const std::string& id)>& remove_evicted) {
  std::unique_lock lock(mutex_);
  Slot* slot = slot_of(id);
  while (slot && slot->opening) {
    opened_.wait(lock);
    slot = slot_of(id);
  }
  if (!slot) return no_such_scene();
  Dropped dropped;
  if (slot->scene) dropped.push_back(slot->scene);
  slot->opening = !slot->scene;  // keeps other threads from opening it meanwhile
  lock.unlock();                 // because the disk may be slow
  Status removed = caught([&] { return dropped.empty() ? remove_evicted(id) : dropped[0]->remove(); });
  lock.lock();
  if (Slot* left = slot_of(id)) left->opening = false;  // another call may have removed the slot
  opened_.notify_all();
  if (!removed.ok()) return removed;
  std::erase_if(slots_, [&](const Slot& one) { return one.id == id; });
  lock.unlock();
  close(std::move(dropped));
  return {};
}

std::vector<SceneSummary> OpenScenes::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<SceneSummary> summaries;
  summaries.reserve(slots_.size());
  for (const Slot& slot : slots_) summaries.push_back(slot.scene ? slot.scene->summary() : slot.summary);
  return summaries;
}

std::size_t OpenScenes::count() const {
  const std::lock_guard lock(mutex_);
  return slots_.size();
}

MemoryUse OpenScenes::memory() const {
  const std::lock_guard lock(mutex_);
  const auto open = std::count_if(slots_.begin(), slots_.end(), [](const Slot& slot) { return slot.scene != nullptr; });
  MemoryUse use{
      .budget = budget_, .bytes = open_bytes(), .copies = copies_bytes(), .open = static_cast<std::size_t>(open)};
  use.evicted = slots_.size() - use.open;
  use.evictions = evictions_, use.reopened = reopened_;
  return use;
}

}  // namespace pelage
