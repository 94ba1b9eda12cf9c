#include "clients/cli/frame_watch.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include "clients/cli/http/connection.h"
#include "protocol/json/decode.h"

namespace pelage {

namespace {

/// The frame that is farthest on: the one that is drawn.
const FrameProgress* drawn_one(const FrameProgressList& list) {
  const FrameProgress* drawn = nullptr;
  for (const FrameProgress& frame : list.frames)
    if (!drawn || frame.share > drawn->share) drawn = &frame;
  return drawn;
}

}  // namespace

FrameWatch::FrameWatch(const Options& options, std::string scene_path)
    : options_(options), scene_path_(std::move(scene_path)) {
  if (!options.json && isatty(STDERR_FILENO) == 1) thread_ = std::thread([this] { watch(); });
}

FrameWatch::~FrameWatch() {
  done_ = true;
  if (thread_.joinable()) thread_.join();
}

void FrameWatch::watch() const {
  auto connection = Connection::to(options_.server, options_.token);
  const auto begun = std::chrono::steady_clock::now();
  auto next = begun + std::chrono::seconds(1);
  bool written = false;
  while (connection && !done_) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (std::chrono::steady_clock::now() < next) continue;
    next += std::chrono::seconds(1);
    const auto answer = connection->get(scene_path_ + "/frames");
    const auto list =
        answer ? decode_answer<FrameProgressList>(answer->body) : Result<FrameProgressList>(answer.status());
    const FrameProgress* frame = list ? drawn_one(*list) : nullptr;
    if (!frame || done_) continue;
    fmt::print(stderr, "\r{:3.0f}% of about {:.0f} s, {:.0f} s so far ", 100 * frame->share, frame->expected_seconds,
               frame->seconds);
    std::fflush(stderr);
    written = true;
  }
  if (written) fmt::print(stderr, "\r\033[K");
}

}  // namespace pelage
