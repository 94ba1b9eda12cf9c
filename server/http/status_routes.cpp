#include "server/http/status_routes.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "server/http/reply.h"
#include "server/http/routes.h"

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

/// Escapes a label value for the text format.
static std::string label_value(const std::string& text) {
  std::string value;
  for (const char c : text) {
    if (c == '"' || c == '\\') value += '\\';
    value += c == '\n' ? ' ' : c;
  }
  return value;
}

static std::string scene_memory(const MemoryUse& use) {
  return single("pelage_scenes_open", "gauge", "Scenes in memory.", use.open) +
         single("pelage_scenes_evicted", "gauge", "Scenes that only the journal has.", use.evicted) +
         single("pelage_scene_memory_bytes", "gauge", "Estimate of what open scenes take.", use.bytes) +
         single("pelage_scene_copies_bytes", "gauge", "Of that, the renderer's copies with their GL buffers.",
                use.copies) +
         single("pelage_scene_memory_budget_bytes", "gauge", "What open scenes and coats may take (--memory).",
                use.budget) +
         single("pelage_scene_evictions_total", "counter", "Times that a scene was evicted.", use.evictions) +
         single("pelage_scene_reopenings_total", "counter", "Times that an evicted scene was opened.", use.reopened);
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
  text += single("pelage_coats_baked_total", "counter", "Coats that were baked for frames.", gauges.coats_baked);
  text += single("pelage_coat_memory_bytes", "gauge", "Baked coats, and those that are being baked; part of --memory.",
                 gauges.coat_bytes);
  text += single("pelage_gl_bytes", "gauge", "Storage of GL buffers, textures and targets.", gauges.gl_bytes);
  text += single("pelage_gl_losses_total", "counter", "Times that the GL was reset or did not answer.",
                 gauges.lost_contexts);
  text += single("pelage_traces_total", "counter", "Pictures of strands that were begun.", gauges.traces.traces);
  text += single("pelage_trace_passes_total", "counter", "Passes that were traced.", gauges.traces.passes);
  text += single("pelage_trace_seconds_total", "counter", "Time that strands were grown and traced.",
                 gauges.traces.seconds);
  text += single("pelage_scenes", "gauge", "Scenes on the server.", gauges.scenes);
  text += scene_memory(gauges.memory);
  text += single("pelage_ready", "gauge", "1 when the server takes work.", gauges.ready ? 1 : 0);
  text += single("pelage_event_streams", "gauge", "Clients that follow a scene.", gauges.streams);
  text += head("pelage_renderer_info", "gauge", "1; `renderer` is what draws.");
  text += fmt::format("pelage_renderer_info{{renderer=\"{}\"}} 1\n", label_value(gauges.renderer));
  text += single("process_resident_memory_bytes", "gauge", "Resident memory.", resident_bytes());
  return text;
}

namespace {

using httplib::Request;
using httplib::Response;

/// Answers whether the server is ready, and lists damaged scenes; damage does not keep clients from the other scenes.
void ready(const Service& service, Response& response) {
  if (Status ready = service.readiness(); !ready.ok()) return reply_problem(response, ready);
  std::string text = "ready\n";
  for (const std::string& damage : service.scenes.damages()) text += damage + "\n";
  response.set_content(text, "text/plain");
}

}  // namespace

Status Service::readiness() const {
  if (draining) return failure(Code::unavailable, "The server is stopping.");
  if (!frames.healthy()) return failure(Code::unavailable, "Drawing does not work.");
  return scenes.health();
}

void add_status_routes(httplib::Server& server, Service& service) {
  server.Get("/livez", [](const Request&, Response& response) { response.set_content("alive\n", "text/plain"); });
  server.Get("/readyz", [&](const Request&, Response& response) { ready(service, response); });
  server.Get("/metrics", [&](const Request&, Response& response) {
    const Gauges gauges{.scenes = service.scenes.count(),
                        .memory = service.scenes.memory(),
                        .ready = service.readiness().ok(),
                        .streams = service.streams.in_use(),
                        .frames_drawn = service.frames.frames_drawn(),
                        .lost_contexts = service.frames.lost_contexts(),
                        .seconds_drawing = service.frames.seconds_drawing(),
                        .coat_bytes = service.frames.coat_bytes(),
                        .coats_baked = service.frames.coats_baked(),
                        .gl_bytes = service.frames.gl_bytes(),
                        .traces = service.traces.counts(),
                        .renderer = service.frames.description()};
    response.set_content(service.metrics.text(gauges), "text/plain; version=0.0.4");
  });
}

}  // namespace pelage
