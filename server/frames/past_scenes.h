// Scenes as they were at earlier revisions, for frames that show them.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "base/status.h"
#include "server/scene/scene.h"

namespace pelage {

/// Thread-safe. Keeps the copies that were asked for last, of all scenes together, so that the next frame of the same
/// revision builds and uploads nothing again. The renderer knows each copy by a copy_id of its own.
class PastScenes {
 public:
  static constexpr std::size_t max_kept = 2;

  /// The scene at a revision: its own snapshot for the present one. Another that is not cached is made from the
  /// journal; commands continue meanwhile. Refused (invalid, "/revision") if the scene's model has no such revision.
  Result<SnapshotPtr> find(const Scene& scene, Revision revision);

  /// Drops the copies of a scene, by its own copy_id.
  void forget(std::uint64_t present);

  /// The copy_id of each copy that nobody holds any more, once: the renderer has no use for it.
  std::vector<std::uint64_t> take_gone();
  bool has_gone() const;

  /// Returns the cached copies of a scene, which is named by its own copy_id.
  std::vector<SnapshotPtr> kept(std::uint64_t present) const;

 private:
  struct Kept {
    std::uint64_t present;
    Revision revision;
    SnapshotPtr copy;
  };
  struct Made {
    std::uint64_t copy_id;
    std::weak_ptr<const SceneSnapshot> copy;
  };

  SnapshotPtr find_kept(std::uint64_t present, Revision revision);
  void keep(Kept copy);
  std::uint64_t new_copy_id();

  mutable std::mutex mutex_;
  std::vector<Kept> kept_;  // the one that was asked for last comes last
  std::vector<Made> made_;  // kept, and held by frames alone
  std::uint64_t ids_ = 0;
};

}  // namespace pelage
