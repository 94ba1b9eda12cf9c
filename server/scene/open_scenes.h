// A cache of open scenes: it evicts the least recently used ones, and opens them again on demand.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "server/scene/scene.h"

namespace pelage {

/// Memory statistics of the server's scenes.
struct MemoryUse {
  std::size_t budget = 0, bytes = 0;          // limit for scenes and baked coats; estimate for open scenes
  std::size_t copies = 0;                     // the part of `bytes` that the renderer's copies take
  std::size_t open = 0, evicted = 0;          // numbers of scenes
  std::uint64_t evictions = 0, reopened = 0;  // counts since the server started
};

/// Thread-safe. Least recent use is determined by a counter, not a clock. Calls wait for no scene, except one that is
/// being opened.
class OpenScenes {
 public:
  using Open = std::function<Result<std::shared_ptr<Scene>>(const std::string& id)>;
  /// Called with the SceneView::copy_id of a scene that was evicted or removed.
  using OnClose = std::function<void(std::uint64_t copy_id)>;
  /// Returns the bytes that the renderer's copy of a scene takes. It is called with a lock held and must not wait for a
  /// scene.
  using CopyBytes = std::function<std::size_t(std::uint64_t copy_id)>;

  /// `open` restores a scene from the journal; it is called without a lock.
  OpenScenes(std::size_t budget, Open open) : budget_(budget), open_(std::move(open)) {}
  /// These setters must be called before other threads use this object.
  void on_close(OnClose on_close) { on_close_ = std::move(on_close); }
  void count_copies(CopyBytes copy_bytes) { copy_bytes_ = std::move(copy_bytes); }
  /// Sets the function that returns the bytes of baked coats, which count against the same budget. It is called as
  /// CopyBytes is.
  void count_coats(std::function<std::size_t()> coat_bytes) { coat_bytes_ = std::move(coat_bytes); }

  /// Refuses (conflict) if the number of scenes is at its limit.
  Status check_scene_limit() const;
  /// Adds an open scene. `write` puts the scene into the journal; it is called only if there is room. Refuses as
  /// check_scene_limit does, and fails as `write` does.
  Status add(const std::shared_ptr<Scene>& scene, const std::function<Status()>& write = {});
  /// Adds a scene that cannot be opened; `summary` says why.
  void add_damaged(const SceneSummary& summary);
  /// Returns a scene, opening it if it was evicted; concurrent callers share one opening. Refuses (not_found) an
  /// unknown id; fails as `open` does.
  Result<std::shared_ptr<Scene>> find(const std::string& id);
  /// Removes a scene. `remove_evicted` removes a scene that is not open from the journal.
  Status remove(const std::string& id, const std::function<Status(const std::string& id)>& remove_evicted);
  /// Returns summaries of all scenes as of their last change, in order of creation.
  std::vector<SceneSummary> list() const;
  std::size_t count() const;
  MemoryUse memory() const;

 private:
  /// An entry of the cache. An evicted scene has a summary and a null `scene`.
  struct Slot {
    std::string id;
    std::shared_ptr<Scene> scene;
    SceneSummary summary = {};
    std::uint64_t last_use = 0;
    bool opening = false;
  };
  using Slots = std::vector<Slot>;
  using Dropped = std::vector<std::shared_ptr<Scene>>;

  // The caller of these must hold the lock.
  Slot* slot_of(const std::string& id);
  std::size_t open_bytes() const;
  std::size_t copies_bytes() const;
  std::size_t coats_bytes() const { return coat_bytes_ ? coat_bytes_() : 0; }
  Slot* next_to_evict();
  /// Evicts scenes until the open ones fit into the budget. The caller frees the returned scenes without the lock,
  /// because freeing a scene takes long.
  Dropped evict_to_budget();

  Result<std::shared_ptr<Scene>> reopen(const std::string& id);
  void close(Dropped dropped) const;

  const std::size_t budget_;
  const Open open_;
  OnClose on_close_;
  CopyBytes copy_bytes_;
  std::function<std::size_t()> coat_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable opened_;
  Slots slots_;             // in order of creation
  std::size_t adding_ = 0;  // number of scenes that are being written to the journal
  std::uint64_t uses_ = 0, evictions_ = 0, reopened_ = 0;
};

}  // namespace pelage
