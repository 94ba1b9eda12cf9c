#include "server/batch/farm_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace pelage {

namespace {

/// Replaces control characters by blanks: a user's text must not begin a line, or a farm would take it for a keyword.
std::string in_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < ' '; }, ' ');
  return text;
}

void write_lines(const std::string& lines) {
  std::fwrite(lines.data(), 1, lines.size(), stdout);
  std::fflush(stdout);
}

}  // namespace

FarmLog::FarmLog(std::chrono::milliseconds interval) : heart_([this, interval] { beat(interval); }) {}

FarmLog::~FarmLog() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  ended_.notify_all();
  heart_.join();
}

void FarmLog::beat(std::chrono::milliseconds interval) {
  std::unique_lock lock(mutex_);
  while (!ended_.wait_for(lock, interval, [&] { return ending_; })) {
    if (!drawing_) continue;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun_;
    write_lines(fmt::format("pelage-render: heartbeat, frame {}, {:.0f} s\n", frame_, passed.count()));
  }
}

void FarmLog::begin(int frame, std::size_t done, std::size_t all) {
  const std::lock_guard lock(mutex_);
  drawing_ = true, frame_ = frame, begun_ = std::chrono::steady_clock::now();
  const double percent = 100.0 * static_cast<double>(done) / static_cast<double>(all);
  write_lines(
      fmt::format("openjd_status: frame {}, {} of {}\nopenjd_progress: {:.2f}\n", frame, done + 1, all, percent));
}

void FarmLog::saved(const std::string& file) {
  const std::lock_guard lock(mutex_);
  write_lines(fmt::format("Saved: '{}'\n", in_one_line(file)));
}

void FarmLog::skipped(const std::string& file) {
  const std::lock_guard lock(mutex_);
  write_lines(fmt::format("Skipped: '{}'\n", in_one_line(file)));
}

void FarmLog::done(std::size_t drawn, std::size_t skipped, double seconds) {
  const std::lock_guard lock(mutex_);
  drawing_ = false;
  write_lines(fmt::format("openjd_progress: 100.00\npelage-render: done, {} drawn, {} skipped, {:.1f} s\n", drawn,
                          skipped, seconds));
}

void FarmLog::failed(const Status& status) {
  const std::lock_guard lock(mutex_);
  drawing_ = false;
  write_lines(fmt::format("openjd_fail: {}\n", in_one_line(status.message)));
  std::string text = fmt::format("pelage-render: {}\n", in_one_line(status.message));
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += fmt::format("  {:<8} {}\n", name, in_one_line(value));
  };
  add("field:", status.pointer), add("limit:", status.limit), add("nearest:", status.nearest),
      add("next:", status.next);
  std::fputs(text.c_str(), stderr);
}

}  // namespace pelage
