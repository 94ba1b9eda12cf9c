// The memory that the renderer holds, for threads that must not wait for it.
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>

#include "renderer/frame/renderer.h"

namespace pelage {

/// Thread-safe. The render thread measures; values are those of the last frame, in bytes.
class RendererMemory {
 public:
  /// Called after the model was drawn.
  void measure(const Renderer& renderer, std::uint64_t model) {
    const std::lock_guard lock(mutex_);
    copies_[model] = renderer.bytes_of(model);
    gl_ = renderer.gl_bytes();
  }
  /// Called after the model's copies were dropped.
  void forget(const Renderer& renderer, std::uint64_t model) {
    const std::lock_guard lock(mutex_);
    copies_.erase(model);
    gl_ = renderer.gl_bytes();
  }

  /// Returns the bytes of the model's copies with their GL objects; 0 if there are none.
  std::size_t of_copies(std::uint64_t model) const {
    const std::lock_guard lock(mutex_);
    const auto found = copies_.find(model);
    return found == copies_.end() ? 0 : found->second;
  }
  /// Returns the bytes of all GL objects.
  std::size_t of_gl() const { return gl_; }

 private:
  mutable std::mutex mutex_;  // held only briefly
  std::map<std::uint64_t, std::size_t> copies_;
  std::atomic<std::size_t> gl_{0};
};

}  // namespace pelage
