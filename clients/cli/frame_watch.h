// How far a long frame is, on the terminal, while it is waited for.
#pragma once

#include <atomic>
#include <string>
#include <thread>
#include <utility>

#include "clients/cli/options.h"

namespace pelage {

/// From when it is made until it is destroyed. Asks the server each second from the first on, on a connection of its
/// own, and writes one line to standard error that it takes away in the end; nothing where that is no terminal.
class FrameWatch {
 public:
  FrameWatch(const Options& options, std::string scene_path);
  ~FrameWatch();
  FrameWatch(const FrameWatch&) = delete;
  FrameWatch& operator=(const FrameWatch&) = delete;

 private:
  void watch() const;

  const Options& options_;
  std::string scene_path_;
  std::atomic<bool> done_ = false;
  std::thread thread_;
};

}  // namespace pelage
