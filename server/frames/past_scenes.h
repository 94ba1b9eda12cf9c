// A cache of scenes at earlier revisions, for frames that show them.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "base/status.h"
#include "server/scene/scene.h"

namespace pelage {

/// Thread-safe. Caches the most recently used copies, over all scenes, so that the next frame of the same revision
/// rebuilds and uploads nothing. Each copy has a copy_id of its own for the renderer.
class PastScenes {
 public:
  static constexpr std::size_t max_cached = 2;

  /// Returns the scene at a revision: its own snapshot for the present one, else a cached copy, or a new one made from
  /// the journal while commands continue. Refuses (invalid, "/revision") a revision that the scene's model does not
  /// have.
  Result<SnapshotPtr> find(const Scene& scene, Revision revision);

  /// Drops the cached copies of a scene; `present` is its own copy_id.
  void forget(std::uint64_t present);

  /// Returns, once, the copy_id of each copy that nobody holds any more, so that the renderer can drop it.
  std::vector<std::uint64_t> take_released();
  bool has_released() const;

  /// Returns the cached copies of a scene; `present` is its own copy_id.
  std::vector<SnapshotPtr> cached(std::uint64_t present) const;

 private:
  struct Cached {
    std::uint64_t present;
    Revision revision;
    SnapshotPtr copy;
  };
  struct Made {
    std::uint64_t copy_id;
    std::weak_ptr<const SceneSnapshot> copy;
  };

  SnapshotPtr find_cached(std::uint64_t present, Revision revision);
  void cache(Cached copy);
  std::uint64_t new_copy_id();

  mutable std::mutex mutex_;
  std::vector<Cached> cached_;  // most recently used last
  std::vector<Made> made_;      // all living copies, cached or held only by frames
  std::uint64_t ids_ = 0;
};

}  // namespace pelage
