// Counters and gauges of the service in Prometheus' text format.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "server/frames/trace_queue.h"
#include "server/scene/open_scenes.h"

namespace pelage {

/// Values that are read when a client asks for the metrics.
struct Gauges {
  std::size_t scenes = 0;
  MemoryUse memory;
  bool ready = false;
  int streams = 0;  // open event streams
  std::size_t frames_drawn = 0, lost_contexts = 0;
  double seconds_drawing = 0;
  std::size_t coat_bytes = 0;
  std::uint64_t coats_baked = 0;
  std::size_t gl_bytes = 0;
  TraceCounts traces;
  std::string renderer;  // what draws, e.g. "AVX2 on the CPU" (FrameService::description)
};

/// Thread-safe.
class Metrics {
 public:
  /// `route` is a template such as "/v1/scenes/{id}", never a path with an id.
  void count_request(const std::string& route, int http_status);
  /// Counts a frame; `seconds` is the time from the request for the picture, after any wait for news, to the encoded
  /// picture, with its time in queues.
  void count_frame(double seconds);
  std::string text(const Gauges& gauges) const;

 private:
  static constexpr std::array<double, 10> bounds_{0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1, 2.5, 5, 10};

  mutable std::mutex mutex_;
  std::map<std::pair<std::string, int>, std::uint64_t> requests_;
  std::array<std::uint64_t, bounds_.size()> frames_within_{};
  std::uint64_t frames_ = 0;
  double frame_seconds_ = 0;
};

}  // namespace pelage
