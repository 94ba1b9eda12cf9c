#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/limits.h"
#include "base/stopwatch.h"
#include "protocol/json/encode.h"
#include "server/http/accept_format.h"
#include "server/http/guard.h"
#include "server/http/reply.h"
#include "server/http/routes.h"
#include "server/http/transport/http_transport.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

constexpr double slice_seconds = 0.25;              // how often a wait checks for a stopping server or a lost client
constexpr std::int64_t large_pixels = 4096 * 4096;  // larger frames are drawn one at a time

/// The query parameters `after`, `after_pass` and `wait`.
struct News {
  std::optional<Revision> after;
  std::optional<SeenPicture> seen;  // the picture that the client has; only with after_pass
  double wait_seconds = 0;
};

template <class T>
std::optional<T> parsed(const std::string& text) {
  T value{};
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || stop != text.data() + text.size()) return {};
  return value;
}

Result<News> news_of(const Request& request, const FrameRequest& wanted) {
  News news;
  for (const char* name : {"after", "after_pass", "wait"}) {
    if (request.get_param_value_count(name) > 1) {
      return failure(Code::malformed, "The parameter is given twice.", std::string("/") + name, "each name once");
    }
  }
  if (request.has_param("after")) {
    news.after = parsed<Revision>(request.get_param_value("after"));
    if (!news.after) return failure(Code::invalid, "This is no revision.", "/after", "[0, 18446744073709551615]");
    if (wanted.revision)
      return failure(Code::invalid, "An earlier revision has no news to wait for.", "/after", "without revision");
  }
  if (request.has_param("after_pass")) {
    const auto passes = parsed<int>(request.get_param_value("after_pass"));
    if (!passes || *passes < 0)
      return failure(Code::invalid, "This is no count of passes.", "/after_pass", "0 or more");
    if (!news.after) return failure(Code::invalid, "after_pass needs a revision.", "/after_pass", "with after");
    if (!wanted.progressive)
      return failure(Code::invalid, "Only progressive pictures have passes.", "/after_pass", "with progressive");
    news.seen = SeenPicture{*news.after, *passes};
  }
  if (request.has_param("wait")) {
    const auto wait = parsed<double>(request.get_param_value("wait"));
    if (!wait || !(*wait >= 0 && *wait <= limits::wait_seconds)) {
      return failure(Code::invalid, "The wait is out of range.", "/wait", fmt::format("[0, {}]", limits::wait_seconds));
    }
    if (!news.after) return failure(Code::invalid, "A wait needs the revision to wait for.", "/after", "required");
    news.wait_seconds = *wait;
  }
  return news;
}

/// Waits until the scene is newer than `after` or a better picture is there, and returns ok then; also without `after`.
/// Fails: unavailable if too many requests wait; not_found if the scene is removed; precondition if nothing newer comes
/// in time.
Status wait_for_news(Service& service, const std::shared_ptr<Scene>& scene, const FrameRequest& wanted,
                     const News& news, const ClientSocket& client) {
  if (!news.after || scene->revision() > *news.after) return {};
  const auto better_picture = [&] {
    return news.seen && service.pictures.has_better_picture(*scene, wanted, *news.seen);
  };
  if (news.seen) {
    if (Status full = service.pictures.improve(scene, wanted, *news.seen); !full.ok()) return full;
    if (better_picture()) return {};
  }
  const Status nothing_new = failure(Code::precondition, "Nothing is newer.");
  if (news.wait_seconds == 0) return nothing_new;
  const auto pass = service.waiting.enter();
  if (!pass)
    return failure(Code::unavailable, "Too many requests are waiting.", "",
                   fmt::format("{}", service.waiting.capacity()));
  const Stopwatch passed;
  while (!service.draining && !client.gone()) {
    const double left = news.wait_seconds - passed.seconds();
    if (left <= 0) break;
    if (scene->wait_newer(*news.after, std::min(left, slice_seconds), better_picture) > *news.after || better_picture())
      return {};
    if (const auto still_there = service.scenes.find(scene->id()); !still_there) return still_there.status();
  }
  return nothing_new;
}

std::string server_timing(const FrameAnswer& frame) {
  const FrameTimings& t = frame.timings;
  if (frame.trace && frame.trace->passes > 0) {
    return fmt::format(
        "queue;dur={:.3f}, upload;dur={:.3f}, draw;dur={:.3f}, grow;dur={:.3f}, trace;dur={:.3f}, "
        "read;dur={:.3f}, encode;dur={:.3f}",
        t.queue, t.upload, t.draw, frame.trace->grow_ms, frame.trace->trace_ms, t.read, t.encode);
  }
  return fmt::format(
      "queue;dur={:.3f}, upload;dur={:.3f}, draw;dur={:.3f}, read;dur={:.3f}, encode;dur={:.3f}, cpu;dur={:.3f}",
      t.queue, t.upload, t.draw, t.read, t.encode, t.cpu);
}

/// Returns a better picture of the revision that the client has, or a picture of what it asks for.
Result<FrameAnswer> picture_of(Service& service, const std::shared_ptr<Scene>& scene, const FrameRequest& wanted,
                               const News& news, const ClientSocket& client) {
  if (news.seen) {
    if (auto better_picture = service.pictures.picture_if_better(*scene, wanted, *news.seen))
      return std::move(*better_picture);
  }
  return service.pictures.frame(scene, wanted, [&client] { return client.gone(); });
}

void reply_frame(Service& service, const std::shared_ptr<Scene>& scene, const FrameRequest& wanted, const News& news,
                 const ClientSocket& client, Response& response) {
  const bool large = std::int64_t{wanted.width} * wanted.height > large_pixels;
  const bool at_once = wanted.knobs.method == Method::shells;  // tracing has a queue of its own
  const auto pass = large && at_once ? service.large_frames.enter() : Gate::Pass(nullptr);
  if (large && at_once && !pass) {
    return reply_problem(response,
                         failure(Code::unavailable, "Another large frame is being drawn.", "", "one at a time"));
  }
  const Stopwatch passed;
  auto frame = picture_of(service, scene, wanted, news, client);
  if (!frame) return reply_problem(response, frame.status());
  service.metrics.count_frame(passed.seconds());
  response.status = 200;
  set_etag(response, frame->revision, frame->trace ? frame->trace->passes : 0);
  response.set_header("Pelage-Revision", std::to_string(frame->revision));
  response.set_header("Pelage-Quality", encode(frame->knobs));
  response.set_header("Pelage-Counters", encode(frame->counters));
  if (frame->estimate) response.set_header("Pelage-Error", encode(*frame->estimate));
  if (!frame->missed.empty()) response.set_header("Pelage-Missed", frame->missed);
  if (frame->trace) response.set_header("Pelage-Trace", encode(*frame->trace));
  response.set_header("Server-Timing", server_timing(*frame));
  response.set_header("Cache-Control", "no-cache");
  response.set_content(frame->bytes, frame->content_type);
}

/// Returns the number of passes of the picture that the client has, as stated by its request.
int known_passes(const FrameRequest& wanted, const News& news) {
  if (news.seen) return news.seen->passes;
  return wanted.knobs.method == Method::strands ? wanted.knobs.trace.passes : 0;
}

void answer_frame(Service& service, const std::shared_ptr<Scene>& scene, const Result<FrameRequest>& wanted,
                  const Request& request, Response& response) {
  if (!wanted) return reply_problem(response, wanted.status());
  const auto news = news_of(request, *wanted);
  if (!news) return reply_problem(response, news.status());
  const Status there = wanted->revision ? scene->has_revision(*wanted->revision) : Status{};
  if (!there.ok()) return reply_problem(response, there);
  const ClientSocket client(request);
  const Status status = wait_for_news(service, scene, *wanted, *news, client);
  const Revision revision = wanted->revision ? *wanted->revision : scene->revision();
  const int passes = known_passes(*wanted, *news);
  const bool known = request.method != "POST" && if_none_match_lists(request, revision, passes);
  if (known || status.code == Code::precondition) {
    response.status = 304;
    return set_etag(response, revision, passes);
  }
  if (!status.ok()) return reply_problem(response, status);
  reply_frame(service, scene, *wanted, *news, client, response);
  Exchange* exchange = exchange_of(request);
  if (exchange && response.has_header("Pelage-Missed"))
    exchange->problem = "missed " + response.get_header_value("Pelage-Missed");
}

/// Answers a dry run with the cost alone.
void answer_cost(Service& service, const std::shared_ptr<Scene>& scene, const Result<FrameRequest>& wanted,
                 const Request& request, Response& response) {
  if (!wanted) return reply_problem(response, wanted.status());
  for (const char* name : {"after", "after_pass", "wait"}) {
    if (request.has_param(name))
      return reply_problem(
          response, failure(Code::invalid, "A dry run waits for nothing.", std::string("/") + name, "without dry_run"));
  }
  const Status there = wanted->revision ? scene->has_revision(*wanted->revision) : Status{};
  if (!there.ok()) return reply_problem(response, there);
  const ClientSocket client(request);
  const auto cost = service.pictures.cost(scene, *wanted, [&client] { return client.gone(); });
  if (!cost) return reply_problem(response, cost.status());
  reply_json(response, 200, encode(*cost));
}

void answer_post(Service& service, const std::shared_ptr<Scene>& scene, const Request& request, Response& response) {
  const Status status = check_query(request, {"after", "after_pass", "wait", "dry_run"});
  const FrameFormat liked = accepted_format(joined_header(request, "Accept"));
  const auto wanted = status.ok() ? decode_frame_request(request.body, liked) : Result<FrameRequest>(status);
  const auto dry_run = is_dry_run(request);
  if (!dry_run) return reply_problem(response, dry_run.status());
  if (*dry_run) return answer_cost(service, scene, wanted, request, response);
  response.set_header("Vary", "Accept");
  answer_frame(service, scene, wanted, request, response);
}

Query frame_query_of(const Request& request) {
  Query query = query_of(request);
  std::erase_if(query, [](const auto& parameter) { return parameter.first == "after" || parameter.first == "wait"; });
  return query;
}

/// Decodes the query of frame.png; other formats than PNG are refused (invalid).
Result<FrameRequest> png_request_of(const Request& request) {
  const auto wanted = decode_frame_query(frame_query_of(request));
  if (!wanted || wanted->format == FrameFormat::png || wanted->format == FrameFormat::png16) return wanted;
  return failure(Code::invalid, "The address of a PNG; POST frames gives other formats.", "/format", "png | png16");
}

}  // namespace

void add_frame_routes(httplib::Server& server, Service& service) {
  add_post(server, "/v1/scenes/([^/]+)/frames", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) { answer_post(service, scene, request, response); });
  });
  server.Get("/v1/scenes/([^/]+)/frames", [&](const Request& request, Response& response) {
    with_scene(service, request, response, [&](const auto& scene) {
      if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
      reply_json(response, 200, encode(service.frames.progress(*scene)));
    });
  });
  server.Get("/v1/scenes/([^/]+)/frame.png", [&](const Request& request, Response& response) {
    with_scene(service, request, response,
               [&](const auto& scene) { answer_frame(service, scene, png_request_of(request), request, response); });
  });
}

}  // namespace pelage
