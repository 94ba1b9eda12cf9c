#include "server/http/http_server.h"

#include <fmt/format.h>
#include <httplib.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>

#include "base/limits.h"
#include "server/http/accept_encoding.h"
#include "server/http/embedded_files.h"
#include "server/http/failures.h"
#include "server/http/guard.h"
#include "server/http/reply.h"
#include "server/http/request_log.h"
#include "server/http/routes.h"
#include "server/http/transport/http_transport.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

constexpr int connection_backlog = 128;  // cpp-httplib's own is 5
constexpr std::size_t requests_per_connection = 10'000;

ReceptionLimits reception_limits() {
  ReceptionLimits limits{.workers = worker_threads};
  rlimit files{};
  // Half of the files that the process may open; the journal, GL and the import worker need some too.
  if (getrlimit(RLIMIT_NOFILE, &files) == 0)
    limits.connections = std::min<std::size_t>(limits.connections, files.rlim_cur / 2);
  return limits;
}

/// Replaces SO_REUSEPORT, which cpp-httplib sets and which lets two servers bind one port.
void set_reuseaddr(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

/// Ignores a range, which HTTP allows: a range of an answer that is computed anew each time means nothing. Adds
/// "Content-Length: 0" where there is no length: such a request has no body (RFC 9112 6.3), but cpp-httplib would read
/// until the connection ends. The const_cast is safe, since the worker that handles the request owns it.
void settle_framing(const Request& request) {
  auto& owned = const_cast<Request&>(request);
  owned.ranges.clear();
  const bool takes_body = request.method == "POST" || request.method == "PUT" || request.method == "DELETE";
  if (takes_body && !request.has_header("Content-Length")) owned.headers.emplace("Content-Length", "0");
}

/// Lets cpp-httplib compress texts by gzip only. Its brotli runs at the slowest setting: half a second for 230 kB, for
/// which gzip takes 12 ms. Files of the studio are left alone, since they were compressed at build time.
void settle_encoding(const Request& request) {
  if (find_embedded_file(request.path)) return;
  const auto chosen = choose_encoding(joined_header(request, "Accept-Encoding"), true, false);
  auto& owned = const_cast<Request&>(request);
  owned.headers.erase("Accept-Encoding");
  if (chosen == ContentCoding::gzip) owned.headers.emplace("Accept-Encoding", "gzip");
}

bool is_probe(const std::string& path) { return path == "/livez" || path == "/readyz" || path == "/metrics"; }

Status early_refusal(const ReceptionLimits& limits, int http_status) {
  if (http_status == 408) {
    return failure(Code::malformed, "The head of the request came too slowly.", "",
                   fmt::format("{} s", limits.head_timeout.count() / 1000));
  }
  if (http_status == 431) {
    return failure(Code::too_large, "The head of the request is too long.", "",
                   fmt::format("at most {} bytes", limits.head_bytes));
  }
  return failure(Code::unavailable, "Too many requests wait.", "", fmt::format("{}", limits.waiting_requests));
}

/// Tells the client the id of its request in the log, and the log the reason of a refusal.
void say_id(Exchange& exchange, Response& response) {
  response.set_header(request_id_header, exchange.id);
  if (exchange.problem.empty()) exchange.problem = response.reason;
}

/// Serializes, without cpp-httplib, an answer that ends its connection.
std::string bytes_of(const Response& response) {
  std::string bytes =
      fmt::format("HTTP/1.1 {} \r\nConnection: close\r\nContent-Length: {}\r\n", response.status, response.body.size());
  for (const auto& [name, value] : response.headers) bytes += fmt::format("{}: {}\r\n", name, value);
  return bytes + "\r\n" + response.body;
}

}  // namespace

struct HttpServer::Impl {
  Impl(const HttpOptions& options, const ServedParts& parts)
      : log(parts.log), service(parts), guard(options.token, options.hosts, !is_loopback_name(options.host)) {
    set_up_transport();
    set_up_handlers();
    answer_failures(server);
    add_scene_routes(server, service);
    add_upload_routes(server, service);
    add_map_routes(server, service);
    add_mesh_routes(server, service);
    add_export_routes(server, service);
    add_command_routes(server, service);
    add_frame_routes(server, service);
    add_pick_routes(server, service);
    add_event_routes(server, service);
    add_status_routes(server, service);
    add_embedded_file_routes(server);
  }

  void set_up_transport() {
    server.set_keep_alive_timeout(std::chrono::duration_cast<std::chrono::seconds>(limits.idle_timeout).count());
    server.set_keep_alive_max_count(requests_per_connection);
    server.set_payload_max_length(limits::model_bytes);
    server.set_tcp_nodelay(true);
    server.set_socket_options([this](socket_t socket) {
      set_reuseaddr(socket);
      listening_socket = socket;
    });
    server.set_default_headers({{"X-Content-Type-Options", "nosniff"}, {"Accept-Ranges", "none"}});
  }

  void set_up_handlers() {
    server.set_expect_100_continue_handler([this](const Request& request, Response& response) {
      const auto refusal = guard.refusal(request);
      if (!refusal) return 100;
      refuse(*refusal, request, response);
      return response.status;
    });
    server.set_pre_routing_handler([this](const Request& request, Response& response) {
      return before_routing(request, response) ? httplib::Server::HandlerResponse::Unhandled
                                               : httplib::Server::HandlerResponse::Handled;
    });
    server.set_post_routing_handler([this](const Request& request, Response& response) {
      service.metrics.count_request(route_of(request.path).path, response.status);
      if (Exchange* exchange = exchange_of(request)) say_id(*exchange, response);
      if (response.get_header_value("Connection") == "close") response.headers.erase("Keep-Alive");
    });
  }

  Status serve() {
    const auto begun = [](const Request& request, Exchange& exchange) {
      exchange.id = new_request_id(request.get_header_value("traceparent"));
    };
    const auto refusal = [this](Exchange& exchange, int http_status) {
      exchange.id = new_request_id("");
      service.metrics.count_request("other", http_status);
      Response response;
      reply_problem(response, early_refusal(limits, http_status), http_status);
      say_id(exchange, response);
      return bytes_of(response);
    };
    const auto ended = [this](const Exchange& exchange) { log_exchange(log, exchange); };
    const bool good = server.serve(limits, {begun, refusal, ended, is_probe});
    return good && service.draining ? Status{} : failure(Code::internal, "The listening socket failed.");
  }

  /// Returns false if the request has been answered already.
  bool before_routing(const Request& request, Response& response) {
    if (const auto refusal = guard.refusal(request)) {
      refuse(*refusal, request, response);
      return false;
    }
    if (service.draining && !is_probe(request.path)) {
      refuse({503, failure(Code::unavailable, "The server is stopping.")}, request, response);
      return false;
    }
    settle_framing(request);
    settle_encoding(request);
    return true;
  }

  const ServerLog& log;
  Service service;
  Guard guard;
  const ReceptionLimits limits = reception_limits();
  HttpTransport server;
  socket_t listening_socket = -1;
  int port = 0;
};

HttpServer::HttpServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
HttpServer::~HttpServer() = default;

Result<std::unique_ptr<HttpServer>> HttpServer::listen(const HttpOptions& options, const ServedParts& parts) {
  if (!is_loopback_name(options.host) && options.token.empty()) {
    return failure(Code::invalid, "An address that others can reach needs a token: --token.", "",
                   "loopback, or a token");
  }
  auto impl = std::make_unique<Impl>(options, parts);
  const bool any_port = options.port == 0;
  if (any_port)
    impl->port = impl->server.bind_to_any_port(options.host);
  else if (impl->server.bind_to_port(options.host, options.port))
    impl->port = options.port;
  if (impl->port <= 0) {
    return failure(Code::invalid, fmt::format("Cannot listen on {}:{}.", options.host, options.port));
  }
  // A second listen() is allowed; it only changes the backlog.
  ::listen(impl->listening_socket, connection_backlog);
  return std::unique_ptr<HttpServer>(new HttpServer(std::move(impl)));
}

int HttpServer::port() const { return impl_->port; }

Status HttpServer::run() { return impl_->serve(); }

void HttpServer::stop() {
  impl_->service.draining = true;
  impl_->service.traces.stop();
  impl_->server.stop_serving();
}

}  // namespace pelage
