#include "server/frames/coat_baker.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace pelage {

namespace {

constexpr std::chrono::milliseconds pause_length{20};  // interval at which free memory for a coat is checked

}  // namespace

bool Bake::fits(const Coat& coat) const { return stage_ <= Stage::baked && same_strands(coat_, coat); }

CoatBaker::CoatBaker(int threads, std::size_t max_bytes, std::function<void()> on_settled)
    : max_bytes_(max_bytes), on_settled_(std::move(on_settled)) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { run(); });
}

CoatBaker::~CoatBaker() {
  stopping_ = true;
  {
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  }
  for (std::thread& thread : threads_) thread.join();
}

CoatBaker::Handle CoatBaker::submit(const Coat& coat) {
  const std::lock_guard lock(mutex_);
  for (const std::weak_ptr<Bake>& known : bakes_) {
    if (BakePtr bake = known.lock(); bake && bake->fits(coat)) return bake;
  }
  std::erase_if(bakes_, [](const auto& bake) { return bake.expired(); });
  auto bake = std::make_shared<Bake>(coat);
  bakes_.push_back(bake);
  changed_.notify_all();
  return bake;
}

std::shared_ptr<const Slices> CoatBaker::wait(const Coat& coat) {
  for (Handle bake = submit(coat);; bake = submit(coat)) {  // again if it was cancelled just as it was requested
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return bake->settled(); });
    }
    if (bake->failed()) std::rethrow_exception(bake->error());
    if (auto slices = bake->slices()) return slices;
    if (stopping_) return nullptr;
  }
}

std::size_t CoatBaker::bytes() const {
  const std::lock_guard lock(mutex_);
  return used_bytes();
}

std::size_t CoatBaker::used_bytes() const {
  std::size_t bytes = 0;
  for (const std::weak_ptr<Bake>& known : bakes_) {
    const BakePtr bake = known.lock();
    if (bake && bake->stage_ == Bake::Stage::baking) bytes += baking_bytes();
    if (bake && bake->stage_ == Bake::Stage::baked) bytes += slices_bytes();
  }
  return bytes;
}

/// Takes the earliest requested bake among those that wait and fit into max_bytes. Returns null if there is none.
CoatBaker::BakePtr CoatBaker::take_fitting() {
  const std::size_t used = used_bytes();
  for (const std::weak_ptr<Bake>& known : bakes_) {
    BakePtr bake = known.lock();
    if (!bake || bake->stage_ != Bake::Stage::waiting) continue;
    const std::size_t needed = baking_bytes();
    if (used > 0 && (needed > max_bytes_ || used > max_bytes_ - needed)) continue;
    bake->stage_ = Bake::Stage::baking;
    return bake;
  }
  return nullptr;
}

CoatBaker::BakePtr CoatBaker::next() {
  std::unique_lock lock(mutex_);
  const auto waits = [](const std::weak_ptr<Bake>& known) {
    const BakePtr bake = known.lock();
    return bake && bake->stage_ == Bake::Stage::waiting;
  };
  while (!stopping_) {
    if (BakePtr bake = take_fitting()) return bake;
    // Polls, because nothing signals that a coat was released.
    if (std::any_of(bakes_.begin(), bakes_.end(), waits))
      changed_.wait_for(lock, pause_length);
    else
      changed_.wait(lock);
  }
  return nullptr;
}

void CoatBaker::run() {
  while (const BakePtr next_one = next()) bake(next_one);
}

void CoatBaker::bake(const BakePtr& bake) {
  const auto go_on = [&] { return !stopping_ && bake.use_count() > 1; };
  try {
    Slices slices = bake_slices(bake->coat_, go_on);
    if (slices.levels.empty()) return settle(*bake, Bake::Stage::cancelled);
    bake->slices_ = std::make_shared<const Slices>(std::move(slices));
    ++baked_;
    settle(*bake, Bake::Stage::baked);
  } catch (...) {
    bake->error_ = std::current_exception();
    settle(*bake, Bake::Stage::failed);
  }
}

void CoatBaker::settle(Bake& bake, Bake::Stage stage) {
  {
    const std::lock_guard lock(mutex_);
    bake.stage_ = stage;
    changed_.notify_all();
  }
  on_settled_();
}

}  // namespace pelage
