// Bakes coats in background threads, each coat once for all frames that wait for it.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "renderer/coat/slices.h"
#include "renderer/coat/strand_tile.h"

namespace pelage {

/// A coat that is being baked, waits to be, or is baked. All who need the coat hold it; its baking is cancelled once
/// nobody does.
class Bake {
 public:
  explicit Bake(Coat coat) : coat_(std::move(coat)) {}

  /// Returns whether its slices are, or will be, those of the coat.
  bool fits(const Coat& coat) const;
  /// Returns whether baking has ended, for any reason.
  bool settled() const { return stage_ >= Stage::baked; }
  bool failed() const { return stage_ == Stage::failed; }
  /// The exception thrown by baking, if failed().
  const std::exception_ptr& error() const { return error_; }
  /// Null until it is settled, and if it was cancelled or failed.
  std::shared_ptr<const Slices> slices() const { return stage_ == Stage::baked ? slices_ : nullptr; }

 private:
  friend class CoatBaker;
  enum class Stage { waiting, baking, baked, cancelled, failed };

  const Coat coat_;
  std::shared_ptr<const Slices> slices_;  // written before `stage_`, as error_ is
  std::exception_ptr error_;
  std::atomic<Stage> stage_{Stage::waiting};
};

/// Bakes coats. Thread-safe. Concurrent requests for one coat share one baking. Coats that are being baked or are still
/// held take at most `max_bytes` together: a coat that does not fit waits for the others, but a single coat is always
/// baked.
class CoatBaker {
 public:
  using Handle = std::shared_ptr<const Bake>;

  /// Bakes up to `threads` coats at a time. `on_settled` is called without a lock each time one is settled.
  CoatBaker(int threads, std::size_t max_bytes, std::function<void()> on_settled);
  ~CoatBaker();
  CoatBaker(const CoatBaker&) = delete;
  CoatBaker& operator=(const CoatBaker&) = delete;

  Handle submit(const Coat& coat);
  /// Bakes a coat and waits for its slices: a CoatSource. Returns null if the baker is being destroyed. Throws what
  /// baking threw.
  std::shared_ptr<const Slices> wait(const Coat& coat);

  /// Returns the bytes of the coats that are being baked or are held.
  std::size_t bytes() const;
  /// Returns the number of coats baked since the start, without cancelled ones.
  std::uint64_t baked() const { return baked_; }

 private:
  using BakePtr = std::shared_ptr<Bake>;

  void run();
  BakePtr next();
  void bake(const BakePtr& bake);
  void settle(Bake& bake, Bake::Stage stage);

  // The caller of these must hold the lock.
  BakePtr take_fitting();
  std::size_t used_bytes() const;

  const std::size_t max_bytes_;
  const std::function<void()> on_settled_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::weak_ptr<Bake>> bakes_;  // in the order of their requests
  std::atomic<std::uint64_t> baked_{0};
  std::atomic<bool> stopping_{false};
  std::vector<std::thread> threads_;
};

}  // namespace pelage
