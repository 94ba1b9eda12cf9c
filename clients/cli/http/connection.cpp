#include "clients/cli/http/connection.h"

#include <fmt/format.h>
#include <httplib.h>
#include <netinet/tcp.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <chrono>
#include <thread>

namespace pelage {

namespace {

constexpr int connection_seconds = 5;
constexpr int answer_seconds = 24 * 3600;                         // long: the server has its own timeouts
constexpr int idle_seconds = 30, probe_seconds = 10, probes = 6;  // TCP keepalive, which detects a dead host
constexpr std::chrono::seconds retry_timeout(60), longest_wait(10);  // for retries while the server is busy
constexpr const char* bytes_type = "application/octet-stream";
constexpr std::size_t piece_bytes = std::size_t{1} << 18;

void keep_alive(socket_t socket) {
  const auto set = [&](int level, int option, int value) { setsockopt(socket, level, option, &value, sizeof value); };
  set(SOL_SOCKET, SO_KEEPALIVE, 1);
  set(IPPROTO_TCP, TCP_KEEPIDLE, idle_seconds);
  set(IPPROTO_TCP, TCP_KEEPINTVL, probe_seconds);
  set(IPPROTO_TCP, TCP_KEEPCNT, probes);
}

/// Returns how long to wait before the request is sent again to a busy server (429); 0 if it is not to be repeated.
std::chrono::seconds wait_after(const HttpAnswer& answer) {
  const auto said = answer.headers.find("retry-after");
  if (answer.status != 429 || said == answer.headers.end()) return {};
  int seconds = 0;
  std::from_chars(said->second.data(), said->second.data() + said->second.size(), seconds);
  return std::clamp(std::chrono::seconds(seconds), std::chrono::seconds(1), longest_wait);
}

/// Returns a request body that is sent in chunks and calls `sent` after each one.
httplib::ContentProvider in_pieces(const std::string& bytes, const Sent& sent) {
  return [&bytes, &sent](std::size_t begin, std::size_t length, httplib::DataSink& sink) {
    const std::size_t piece = std::min(length, piece_bytes);
    const bool went = sink.write(bytes.data() + begin, piece);
    if (went && sent) sent(begin + piece);
    return went;
  };
}

HttpAnswer answer_of(const httplib::Response& response) {
  HttpAnswer answer{.status = response.status, .body = response.body, .headers = {}};
  for (const auto& [name, value] : response.headers) {
    std::string lower = name;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
    answer.headers[lower] = value;
  }
  return answer;
}

}  // namespace

struct Connection::Impl {
  Impl(std::string address, const std::string& token) : server(std::move(address)), client(server) {
    client.set_connection_timeout(connection_seconds);
    client.set_read_timeout(answer_seconds);
    client.set_write_timeout(answer_seconds);
    client.set_keep_alive(true);
    client.set_socket_options(keep_alive);
    client.set_tcp_nodelay(true);
    if (!token.empty()) client.set_bearer_token_auth(token);
  }

  Result<HttpAnswer> result_of(const httplib::Result& result) const {
    if (result) return answer_of(*result);
    return with_next(
        failure(Code::unavailable, fmt::format("No answer from {} ({}).", server, httplib::to_string(result.error()))),
        "start a server with `pelaged`, or name it with --server or PELAGE_SERVER");
  }

  /// Returns the answer to `ask()`, which is repeated while the server is busy, for up to `retry_timeout`.
  template <class Ask>
  Result<HttpAnswer> answer_to(const Ask& ask) const {
    const auto given_up = std::chrono::steady_clock::now() + retry_timeout;
    for (;;) {
      Result<HttpAnswer> answer = result_of(ask());
      const std::chrono::seconds wait = answer ? wait_after(*answer) : std::chrono::seconds();
      if (wait.count() == 0 || std::chrono::steady_clock::now() + wait > given_up) return answer;
      fmt::print(stderr, "The server is busy; asking again in {} s.\n", wait.count());
      std::this_thread::sleep_for(wait);
    }
  }

  std::string server;
  httplib::Client client;
};

Connection::Connection(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Connection::~Connection() = default;
Connection::Connection(Connection&&) noexcept = default;
Connection& Connection::operator=(Connection&&) noexcept = default;

Result<Connection> Connection::to(const std::string& server, const std::string& token, const HttpHeaders& always) {
  static const std::string scheme = "http://";
  std::string address = server;
  while (!address.empty() && address.back() == '/') address.pop_back();
  if (!address.starts_with(scheme) || address.size() == scheme.size() ||
      address.find_first_of("/?#@ ", scheme.size()) != std::string::npos) {
    return failure(Code::invalid, "\"" + server + "\" is no address of a server.", "", "http://HOST:PORT");
  }
  auto impl = std::make_unique<Impl>(address, token);
  if (!impl->client.is_valid()) {
    return failure(Code::invalid, "\"" + server + "\" is no address of a server.", "", "http://HOST:PORT");
  }
  impl->client.set_default_headers(httplib::Headers(always.begin(), always.end()));
  return Connection(std::move(impl));
}

Result<HttpAnswer> Connection::get(const std::string& path) {
  return impl_->answer_to([&] { return impl_->client.Get(path); });
}

Result<HttpAnswer> Connection::get(const std::string& path, const std::function<bool(std::string_view)>& take) {
  bool success = false;
  std::string problem;
  const auto begin = [&](const httplib::Response& response) {
    success = response.status >= 200 && response.status < 300;
    problem.clear();
    return true;
  };
  const auto receive = [&](const char* data, std::size_t size) {
    if (success) return take({data, size});
    problem.append(data, size);
    return true;
  };
  Result<HttpAnswer> answer = impl_->answer_to([&] { return impl_->client.Get(path, begin, receive); });
  if (answer) answer->body = std::move(problem);
  return answer;
}

Result<HttpAnswer> Connection::post_json(const std::string& path, const std::string& body, const HttpHeaders& headers) {
  const httplib::Headers sent(headers.begin(), headers.end());
  return impl_->answer_to([&] { return impl_->client.Post(path, sent, body, "application/json"); });
}

Result<HttpAnswer> Connection::post_bytes(const std::string& path, const std::string& bytes, const Sent& sent) {
  return impl_->answer_to([&] {
    if (bytes.empty()) return impl_->client.Post(path, bytes, bytes_type);
    return impl_->client.Post(path, bytes.size(), in_pieces(bytes, sent), bytes_type);
  });
}

Result<HttpAnswer> Connection::put_bytes(const std::string& path, const std::string& bytes, const Sent& sent) {
  return impl_->answer_to([&] {
    if (bytes.empty()) return impl_->client.Put(path, bytes, bytes_type);
    return impl_->client.Put(path, bytes.size(), in_pieces(bytes, sent), bytes_type);
  });
}

Result<HttpAnswer> Connection::remove(const std::string& path) {
  return impl_->answer_to([&] { return impl_->client.Delete(path); });
}

}  // namespace pelage
