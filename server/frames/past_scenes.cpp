#include "server/frames/past_scenes.h"

#include <algorithm>
#include <utility>

namespace pelage {

Result<PastCopy> PastScenes::find(const Scene& scene, Revision revision) {
  if (scene.is_at(revision)) return PastCopy();
  const std::uint64_t present = scene.memory().copy_id;
  if (PastCopy known = find_kept(present, revision)) return known;
  Result<SceneCopy> made = scene.copy_at(revision, new_copy_id());
  if (!made) return made.status();
  auto copy = std::make_shared<const SceneCopy>(std::move(*made));
  keep({present, revision, copy});
  // Whoever gives the scene another model or removes it says so first, and has its copies forgotten then.
  if (scene.removed() || scene.memory().copy_id != present) forget(present);
  return PastCopy(std::move(copy));
}

PastCopy PastScenes::find_kept(std::uint64_t present, Revision revision) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const Kept& one) { return one.present == present && one.revision == revision; });
  if (found == kept_.end()) return nullptr;
  std::rotate(found, found + 1, kept_.end());
  return kept_.back().copy;
}

/// Caches a copy, and evicts the least recently used one if there are too many. Two callers that ask for the same copy
/// at once may both make it; the older one is then evicted first.
void PastScenes::keep(Kept copy) {
  PastCopy dropped;  // freed without the lock
  const std::lock_guard lock(mutex_);
  made_.push_back({copy.copy->view().copy_id, copy.copy});
  kept_.push_back(std::move(copy));
  if (kept_.size() <= max_kept) return;
  dropped = std::move(kept_.front().copy);
  kept_.erase(kept_.begin());
}

/// Scenes have ids that count from 1.
std::uint64_t PastScenes::new_copy_id() {
  const std::lock_guard lock(mutex_);
  return (std::uint64_t{1} << 63) + ids_++;
}

void PastScenes::forget(std::uint64_t present) {
  const std::lock_guard lock(mutex_);
  std::erase_if(kept_, [&](const Kept& one) { return one.present == present; });
}

std::vector<std::uint64_t> PastScenes::take_gone() {
  std::vector<std::uint64_t> gone;
  const std::lock_guard lock(mutex_);
  std::erase_if(made_, [&](const Made& one) {
    if (one.copy.expired()) gone.push_back(one.copy_id);
    return one.copy.expired();
  });
  return gone;
}

bool PastScenes::has_gone() const {
  const std::lock_guard lock(mutex_);
  return std::any_of(made_.begin(), made_.end(), [](const Made& one) { return one.copy.expired(); });
}

std::vector<PastCopy> PastScenes::kept(std::uint64_t present) const {
  std::vector<PastCopy> copies;
  const std::lock_guard lock(mutex_);
  for (const Kept& one : kept_) {
    if (one.present == present) copies.push_back(one.copy);
  }
  return copies;
}

}  // namespace pelage
