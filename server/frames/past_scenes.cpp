#include "server/frames/past_scenes.h"

#include <algorithm>
#include <utility>

namespace pelage {

Result<SnapshotPtr> PastScenes::find(const Scene& scene, Revision revision) {
  SnapshotPtr now = scene.snapshot();
  if (now->revision == revision && !scene.removed()) return now;
  if (SnapshotPtr known = find_cached(now->copy_id, revision)) return known;
  Result<SceneSnapshot> made = scene.snapshot_at(revision);
  if (!made) return made.status();
  made->copy_id = new_copy_id(), made->pose = nullptr;
  auto copy = std::make_shared<const SceneSnapshot>(std::move(*made));
  cache({now->copy_id, revision, copy});
  // The scene may have been removed or got another model meanwhile. Both are visible here before the store forgets the
  // scene's copies, so a copy that was cached too late is dropped here.
  if (scene.removed() || scene.snapshot()->copy_id != now->copy_id) forget(now->copy_id);
  return SnapshotPtr(std::move(copy));
}

SnapshotPtr PastScenes::find_cached(std::uint64_t present, Revision revision) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(cached_.begin(), cached_.end(), [&](const Cached& one) {
    return one.present == present && one.revision == revision;
  });
  if (found == cached_.end()) return nullptr;
  std::rotate(found, found + 1, cached_.end());
  return cached_.back().copy;
}

/// Caches a copy, and evicts the least recently used one if there are too many. Two concurrent callers may both make
/// the same copy; the older one is then evicted first.
void PastScenes::cache(Cached copy) {
  SnapshotPtr dropped;  // freed after the lock is released
  const std::lock_guard lock(mutex_);
  made_.push_back({copy.copy->copy_id, copy.copy});
  cached_.push_back(std::move(copy));
  if (cached_.size() <= max_cached) return;
  dropped = std::move(cached_.front().copy);
  cached_.erase(cached_.begin());
}

/// Returns a copy_id outside the range of scene ids, which count from 1.
std::uint64_t PastScenes::new_copy_id() {
  const std::lock_guard lock(mutex_);
  return (std::uint64_t{1} << 63) + ids_++;
}

void PastScenes::forget(std::uint64_t present) {
  const std::lock_guard lock(mutex_);
  std::erase_if(cached_, [&](const Cached& one) { return one.present == present; });
}

std::vector<std::uint64_t> PastScenes::take_released() {
  std::vector<std::uint64_t> gone;
  const std::lock_guard lock(mutex_);
  std::erase_if(made_, [&](const Made& one) {
    if (one.copy.expired()) gone.push_back(one.copy_id);
    return one.copy.expired();
  });
  return gone;
}

bool PastScenes::has_released() const {
  const std::lock_guard lock(mutex_);
  return std::any_of(made_.begin(), made_.end(), [](const Made& one) { return one.copy.expired(); });
}

std::vector<SnapshotPtr> PastScenes::cached(std::uint64_t present) const {
  std::vector<SnapshotPtr> copies;
  const std::lock_guard lock(mutex_);
  for (const Cached& one : cached_) {
    if (one.present == present) copies.push_back(one.copy);
  }
  return copies;
}

}  // namespace pelage
