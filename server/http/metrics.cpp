#include "server/http/metrics.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

namespace pelage {

namespace {

std::size_t resident_bytes() {
  std::ifstream statm("/proc/self/statm");
  std::size_t total = 0, resident = 0;
  statm >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

std::string head(const char* name, const char* type, const char* help) {
  return fmt::format("# HELP {} {}\n# TYPE {} {}\n", name, help, name, type);
}

template <class T>
std::string single(const char* name, const char* type, const char* help, T value) {
  return head(name, type, help) + fmt::format("{} {}\n", name, value);
}

}  // namespace

void Metrics::count_request(const std::string& route, int http_status) {
  const std::lock_guard lock(mutex_);
  ++requests_[{route, http_status}];
}

void Metrics::count_frame(double seconds) {
  const std::lock_guard lock(mutex_);
  for (std::size_t i = 0; i < bounds_.size(); ++i) frames_within_[i] += seconds <= bounds_[i] ? 1 : 0;
  ++frames_;
  frame_seconds_ += seconds;
}

/// Escaped as the text format wants it.
static std::string label_value(const std::string& text) {
  std::string value;
  for (const char c : text) {
    if (c == '"' || c == '\\') value += '\\';
    value += c == '\n' ? ' ' : c;
  }
  return value;
}

std::string Metrics::text(const Gauges& gauges) const {
  const std::lock_guard lock(mutex_);
  std::string text = head("pelage_requests_total", "counter", "Answers by route and status.");
  for (const auto& [key, count] : requests_) {
    text += fmt::format("pelage_requests_total{{route=\"{}\",status=\"{}\"}} {}\n", key.first, key.second, count);
  }
  text += head("pelage_frame_seconds", "histogram", "Time of a frame from request to encoded picture.");
  for (std::size_t i = 0; i < bounds_.size(); ++i) {
    text += fmt::format("pelage_frame_seconds_bucket{{le=\"{}\"}} {}\n", bounds_[i], frames_within_[i]);
  }
  text += fmt::format("pelage_frame_seconds_bucket{{le=\"+Inf\"}} {}\n", frames_);
  text += fmt::format("pelage_frame_seconds_sum {}\npelage_frame_seconds_count {}\n", frame_seconds_, frames_);
  text += single("pelage_frames_total", "counter", "Frames that the render thread drew.", gauges.frames_drawn);
  text +=
      single("pelage_drawing_seconds_total", "counter", "Time that the render thread drew.", gauges.seconds_drawing);
  text += single("pelage_traces_total", "counter", "Pictures of strands that were begun.", gauges.traces.traces);
  text += single("pelage_trace_passes_total", "counter", "Passes that were traced.", gauges.traces.passes);
  text += single("pelage_trace_seconds_total", "counter", "Time that strands were grown and traced.", gauges.traces.seconds);
  text += single("pelage_scenes", "gauge", "Scenes on the server.", gauges.scenes);
  text += single("pelage_ready", "gauge", "1 when the server takes work.", gauges.ready ? 1 : 0);
  text += head("pelage_renderer_info", "gauge", "1; `renderer` is what draws.");
  text += fmt::format("pelage_renderer_info{{renderer=\"{}\"}} 1\n", label_value(gauges.renderer));
  text += single("process_resident_memory_bytes", "gauge", "Resident memory.", resident_bytes());
  return text;
}

}  // namespace pelage
