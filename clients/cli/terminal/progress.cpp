#include "clients/cli/terminal/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "clients/cli/terminal/report.h"

namespace pelage {

namespace {

constexpr int bar_cells = 20;
constexpr std::chrono::milliseconds initial_delay(1000), redraw_interval(500), poll_interval(20);

}  // namespace

std::string progress_text(const std::string& label, const ProgressState& state, double seconds) {
  std::string text = label;
  if (state.share >= 0) {
    const double share = std::min(state.share, 1.0);
    const auto full = static_cast<std::size_t>(std::floor(share * bar_cells));
    text +=
        " [" + std::string(full, '#') + std::string(bar_cells - full, '.') + fmt::format("] {:3.0f} %", 100 * share);
  }
  if (!state.details.empty()) text += ", " + state.details;
  return text + fmt::format(", {:.0f} s", seconds);
}

ProgressLine::ProgressLine(std::string label, std::function<ProgressState()> get_state)
    : label_(std::move(label)), get_state_(std::move(get_state)) {
  if (!reports_json() && isatty(STDERR_FILENO) == 1) thread_ = std::thread([this] { draw(); });
}

ProgressLine::~ProgressLine() {
  done_ = true;
  if (thread_.joinable()) thread_.join();
}

void ProgressLine::draw() const {
  const auto begun = std::chrono::steady_clock::now();
  auto next = begun + initial_delay;
  bool written = false;
  while (!done_) {
    std::this_thread::sleep_for(poll_interval);
    const auto now = std::chrono::steady_clock::now();
    if (now < next) continue;
    next = now + redraw_interval;
    const ProgressState state = get_state_ ? get_state_() : ProgressState{};
    if (done_) break;
    fmt::print(stderr, "\r{}\033[K", progress_text(label_, state, std::chrono::duration<double>(now - begun).count()));
    std::fflush(stderr);
    written = true;
  }
  if (written) fmt::print(stderr, "\r\033[K");
}

}  // namespace pelage
