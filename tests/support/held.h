// Something that goes on until a test lets it go, so that the test sees what others do meanwhile.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <future>
#include <memory>
#include <utility>

#include "server/groom/cancel.h"

namespace pelage::testing {

constexpr std::chrono::seconds hang_guard(60);  // only against a hang

/// On a thread of its own.
class Held {
 public:
  /// `work` calls what it is given once it is in the middle, which returns when it is let go.
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

/// A cancel that nobody asks for; it calls `middle` when it is asked for the time after `after` others.
inline Cancel that_waits(const std::function<void()>& middle, int after = 1) {
  return Cancel([middle, left = std::make_shared<int>(after)] {
    if ((*left)-- == 0) middle();
    return false;
  });
}

/// Does the work on a thread of its own; the test program ends where it hangs, as nothing else would end it.
inline void expect_ends(const char* what, const std::function<void()>& work) {
  auto ended = std::async(std::launch::async, work);
  if (ended.wait_for(hang_guard) != std::future_status::ready) {
    ADD_FAILURE() << what << " waits";
    std::quick_exit(1);
  }
  ended.get();
}

}  // namespace pelage::testing
