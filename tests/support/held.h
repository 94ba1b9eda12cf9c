// Work that goes on until a test releases it, so that the test sees what others can do meanwhile.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <utility>

#include "server/groom/cancel.h"

namespace pelage::testing {

constexpr std::chrono::seconds hang_guard(60);  // a timeout that only a hang reaches

/// Runs work on its own thread.
class Held {
 public:
  /// Passes a function to `work`, which has to call it when it is in the middle. That function returns when end() is
  /// called.
  explicit Held(const std::function<void(const std::function<void()>&)>& work)
      : thread_(std::async(std::launch::async, [this, work] {
          work([this] {
            begun_.set_value();
            let_go_.get_future().wait();
          });
        })) {
    EXPECT_EQ(begun_.get_future().wait_for(hang_guard), std::future_status::ready);
  }
  ~Held() { end(); }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

  void end() {
    if (!std::exchange(ended_, true)) let_go_.set_value();
    if (thread_.valid()) thread_.get();
  }

 private:
  std::promise<void> begun_, let_go_;
  bool ended_ = false;
  std::future<void> thread_;
};

/// A cancel that never cancels. When it is polled after `after` other polls, it calls `middle`.
inline Cancel that_waits(const std::function<void()>& middle, int after = 1) {
  return Cancel([middle, left = std::make_shared<int>(after)] {
    if ((*left)-- == 0) middle();
    return false;
  });
}

/// Does the work on its own thread. Ends the test program if the work hangs, as nothing else would end it.
inline void expect_ends(const char* what, const std::function<void()>& work) {
  auto ended = std::async(std::launch::async, work);
  if (ended.wait_for(hang_guard) != std::future_status::ready) {
    ADD_FAILURE() << what << " waits";
    std::quick_exit(1);
  }
  ended.get();
}

}  // namespace pelage::testing
