#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <utility>

#include "base/stopwatch.h"
#include "protocol/json/encode.h"
#include "server/http/guard.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

constexpr double check_seconds = 0.25;  // how often a stream checks for a stopping server or a lost client
constexpr double heartbeat_seconds = 15;
constexpr const char* retry_line = "retry: 1000\n\n";  // a disconnected client comes back after this many milliseconds

std::string event_text(const char* name, Revision revision, const std::string& data) {
  return fmt::format("event: {}\nid: {}\ndata: {}\n\n", name, revision, data);
}

/// Sends the events of a scene to one client. Keeps the scene open.
class EventStream {
 public:
  /// `seen` is the last revision that the client knows; none for a new client.
  EventStream(const Service& service, std::shared_ptr<const Scene> scene, std::optional<Revision> seen, Gate::Pass pass,
              const Request& request)
      : service_(service), scene_(std::move(scene)), seen_(seen), pass_(std::move(pass)), client_(request) {}

  /// Waits up to check_seconds for changes and sends them. Returns false at the end of the stream.
  bool send(httplib::DataSink& sink) {
    if (seen_ && pending_.empty()) scene_->wait_newer(*seen_, check_seconds);
    if (client_.gone()) return false;
    std::string text = std::exchange(pending_, {}) + news();
    if (text.empty() && quiet_.seconds() >= heartbeat_seconds) text = ":\n\n";
    if (!text.empty()) {
      quiet_ = {};
      if (!sink.write(text.data(), text.size())) return false;
    }
    if (!ended_ && !service_.draining) return true;
    sink.done();
    return false;
  }

 private:
  std::string news() {
    if (scene_->removed()) {
      ended_ = true;
      return "event: removed\ndata: {}\n\n";
    }
    const auto [now, changes] = scene_->news(seen_);
    const bool follows = seen_ && now.first_revision <= *seen_ && *seen_ <= now.revision;
    std::string text;
    for (const ChangeEvent& change : changes) {
      text += event_text("change", change.revision, encode(change));
      seen_ = change.revision;
    }
    if (follows && (knows_scene_ || *seen_ < now.revision)) return text;
    seen_ = now.revision, knows_scene_ = true;
    return text + event_text("scene", now.revision, encode(now));
  }

  const Service& service_;
  const std::shared_ptr<const Scene> scene_;
  std::optional<Revision> seen_;
  const Gate::Pass pass_;
  const ClientSocket client_;
  std::string pending_ = retry_line;
  Stopwatch quiet_;
  bool knows_scene_ = false, ended_ = false;
};

/// Returns the revision of Last-Event-ID; none without the header. Fails (malformed) if it is no revision.
Result<std::optional<Revision>> last_event_of(const Request& request) {
  const std::string text = request.get_header_value("Last-Event-ID");
  if (text.empty()) return std::optional<Revision>();
  Revision revision = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), revision);
  if (error == std::errc() && stop == text.data() + text.size()) return std::optional(revision);
  return failure(Code::malformed, "Last-Event-ID is no id of an event.", "", "a revision");
}

void follow(Service& service, const std::shared_ptr<Scene>& scene, const Request& request, Response& response) {
  if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
  const auto seen = last_event_of(request);
  if (!seen) return reply_problem(response, seen.status());
  auto pass = service.streams.enter();
  if (!pass) {
    return reply_problem(response, failure(Code::unavailable, "Too many clients follow scenes.", "",
                                           fmt::format("{}", service.streams.capacity())));
  }
  response.set_header("Cache-Control", "no-store");
  response.set_header("X-Accel-Buffering", "no");                            // nginx passes events on at once
  if (request.method != "HEAD") response.set_header("Connection", "close");  // send() returns false at the end
  const auto stream = std::make_shared<EventStream>(service, scene, *seen, std::move(pass), request);
  response.set_chunked_content_provider("text/event-stream",
                                        [stream](std::size_t, httplib::DataSink& sink) { return stream->send(sink); });
}

}  // namespace

void add_event_routes(httplib::Server& server, Service& service) {
  server.Get("/v1/scenes/([^/]+)/events", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { follow(service, scene, request, response); });
  });
}

}  // namespace pelage
