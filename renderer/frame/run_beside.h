// Long work of the CPU beside the thread that draws.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <optional>
#include <type_traits>

#include "renderer/frame/pieces.h"

namespace pelage {

/// Calls `work(go_on)` on a thread of its own, and `pause` again and again on this one until it is done. Once the pause
/// gives up, `go_on` is false and the answer none: work that asks it often ends soon. Where no thread can be started
/// the work is done here.
template <class Work>
auto run_beside(const Pause& pause, const Work& work)
    -> std::optional<std::invoke_result_t<Work, const std::function<bool()>&>> {
  constexpr std::chrono::milliseconds between_pauses{5};
  std::atomic<bool> wanted = true;
  const std::function<bool()> go_on = [&] { return wanted.load(); };
  auto answer = std::async(std::launch::async | std::launch::deferred, [&] { return work(go_on); });
  try {
    while (answer.wait_for(between_pauses) == std::future_status::timeout) {
      if (wanted && !pause()) wanted = false;
    }
  } catch (...) {  // of the pause: nobody wants the answer, and the future's end waits for the work
    wanted = false;
    throw;
  }
  auto result = answer.get();
  if (!wanted) return {};
  return result;
}

}  // namespace pelage
