// Which scenes are in memory: the least recently used ones are evicted and opened again when they are asked for.
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

/// How the scenes of a server share its memory.
struct MemoryUse {
  std::size_t budget = 0, bytes = 0;          // what scenes and coats may take, and open scenes take, estimated
  std::size_t copies = 0;                     // of these bytes, the renderer's copies
  std::size_t open = 0, evicted = 0;          // scenes
  std::uint64_t evictions = 0, reopened = 0;  // since the start
};

/// Thread-safe. Use is counted and not timed. Waits for no scene but one that is being opened.
class OpenScenes {
 public:
  using Open = std::function<Result<std::shared_ptr<Scene>>(const std::string& id)>;
  /// Called with the copy_id of a scene that was evicted or removed.
  using OnClose = std::function<void(std::uint64_t copy_id)>;
  /// What the renderer's copy of a scene takes; asked with a lock held, so it waits for no scene.
  using CopyBytes = std::function<std::size_t(std::uint64_t copy_id)>;

  /// `open` makes a scene from the journal; it runs without a lock.
  OpenScenes(std::size_t budget, Open open) : budget_(budget), open_(std::move(open)) {}
  /// To be called before anyone else uses this object.
  void on_close(OnClose on_close) { on_close_ = std::move(on_close); }
  void count_copies(CopyBytes copy_bytes) { copy_bytes_ = std::move(copy_bytes); }
  /// Sets what baked coats take, which counts against the same budget; asked as CopyBytes is.
  void count_coats(std::function<std::size_t()> coat_bytes) { coat_bytes_ = std::move(coat_bytes); }

  /// Refused (busy) at the limit of scenes, as `add` does.
  Status has_room() const;
  /// Adds an open scene. `write` puts the scene into the journal, and runs if there is room.
  Status add(const std::shared_ptr<Scene>& scene, const std::function<Status()>& write = {});
  /// Adds one that cannot be opened, as its summary says.
  void add_damaged(const SceneSummary& summary);
  /// Opens an evicted scene, once for all who ask for it. Refused (not_found); fails as `open` does.
  Result<std::shared_ptr<Scene>> find(const std::string& id);
  /// `remove_evicted` takes a scene out of the journal that is not open.
  Status remove(const std::string& id, const std::function<Status(const std::string& id)>& remove_evicted);
  /// As they were after their last change, in the order they were made in.
  std::vector<SceneSummary> list() const;
  std::size_t count() const;
  MemoryUse memory() const;

 private:
  /// A scene that is evicted has a summary and no `scene`.
  struct Slot {
    std::string id;
    std::shared_ptr<Scene> scene;
    SceneSummary summary = {};
    std::uint64_t last_use = 0;
    bool opening = false;
  };
  using Slots = std::vector<Slot>;
  using Dropped = std::vector<std::shared_ptr<Scene>>;

  // All of these need the lock.
  Slot* slot_of(const std::string& id);
  std::size_t open_bytes() const;
  std::size_t copies_bytes() const;
  std::size_t coats_bytes() const { return coat_bytes_ ? coat_bytes_() : 0; }
  Slot* next_to_evict();
  /// Evicts until the open scenes fit. The caller lets go of them without the lock: to free one takes long.
  Dropped keep_to_budget();

  Result<std::shared_ptr<Scene>> reopen(const std::string& id);
  void close(Dropped dropped) const;

  const std::size_t budget_;
  const Open open_;
  OnClose on_close_;
  CopyBytes copy_bytes_;
  std::function<std::size_t()> coat_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable opened_;
  Slots slots_;             // in the order that the scenes were made in
  std::size_t adding_ = 0;  // scenes that the journal is about to have
  std::uint64_t uses_ = 0, evictions_ = 0, reopened_ = 0;
};

}  // namespace pelage
