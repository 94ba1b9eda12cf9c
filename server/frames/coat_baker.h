// Coats are baked beside the render thread: each once, for all frames that wait for it.
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

/// A coat that is being baked or waits to be. Everybody who wants the coat holds it; once nobody does, its baking ends.
class Bake {
 public:
  explicit Bake(Coat coat) : coat_(std::move(coat)) {}

  /// Returns whether its slices are the coat's, now or later.
  bool fits(const Coat& coat) const;
  /// Returns whether nothing is to be waited for any more.
  bool settled() const { return stage_ >= Stage::baked; }
  bool failed() const { return stage_ == Stage::failed; }
  /// What was thrown, of one that failed.
  const std::exception_ptr& error() const { return error_; }
  /// Null before it is settled, and where it ended without any.
  std::shared_ptr<const Slices> slices() const { return stage_ == Stage::baked ? slices_ : nullptr; }

 private:
  friend class CoatBaker;
  enum class Stage { waiting, baking, baked, given_up, failed };

  const Coat coat_;
  std::shared_ptr<const Slices> slices_;  // written before `stage_`, as the error is
  std::exception_ptr error_;
  std::atomic<Stage> stage_{Stage::waiting};
};

/// Bakes coats. Thread-safe. Bakes a coat once for all who ask for it meanwhile. Coats that are being baked or are
/// still held take at most `room` bytes together: a coat that does not fit waits for the others, but one alone is
/// always baked.
class CoatBaker {
 public:
  using Handle = std::shared_ptr<const Bake>;

  /// Bakes so many coats at a time. `on_settled` is called without a lock each time one is settled.
  CoatBaker(int threads, std::size_t room, std::function<void()> on_settled);
  ~CoatBaker();
  CoatBaker(const CoatBaker&) = delete;
  CoatBaker& operator=(const CoatBaker&) = delete;

  Handle ask(const Coat& coat);
  /// Waits for the slices, as CoatSource has it. Throws what baking them threw.
  std::shared_ptr<const Slices> wait(const Coat& coat);

  /// Returns the bytes of the coats that are being baked or are held.
  std::size_t bytes() const;
  /// Returns how many coats were baked to the end since the start.
  std::uint64_t baked() const { return baked_; }

 private:
  using BakePtr = std::shared_ptr<Bake>;

  void run();
  BakePtr next();
  void bake(const BakePtr& bake);
  void settle(Bake& bake, Bake::Stage stage);

  // These need the lock.
  BakePtr take_fitting();
  std::size_t held_bytes() const;

  const std::size_t room_;
  const std::function<void()> on_settled_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::weak_ptr<Bake>> bakes_;  // in the order that they were asked for
  std::atomic<std::uint64_t> baked_{0};
  std::atomic<bool> stopping_{false};
  std::vector<std::thread> threads_;
};

}  // namespace pelage
