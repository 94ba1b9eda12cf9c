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

constexpr int connect_timeout_seconds = 5;
constexpr int answer_timeout_seconds = 24 * 3600;                 // long: the server has its own timeouts
constexpr int idle_seconds = 30, probe_seconds = 10, probes = 6;  // TCP keepalive, which detects a dead host
constexpr std::chrono::seconds retry_timeout(60), max_wait(10);   // for retries while the server is busy
constexpr const char* bytes_type = "application/octet-stream";
constexpr std::size_t chunk_bytes = std::size_t{1} << 18;

void keep_alive(socket_t socket) {
  const auto set = [&](int level, int option, int value) { setsockopt(socket, level, option, &value, sizeof value); };
  set(SOL_SOCKET, SO_KEEPALIVE, 1);
  set(IPPROTO_TCP, TCP_KEEPIDLE, idle_seconds);
  set(IPPROTO_TCP, TCP_KEEPINTVL, probe_seconds);
  set(IPPROTO_TCP, TCP_KEEPCNT, probes);
}

/// Returns how long to wait before the request is sent again to a busy server (429); 0 if it is not to be repeated.
std::chrono::seconds retry_delay(const HttpAnswer& answer) {
  const auto retry_after = answer.headers.find("retry-after");
  if (answer.status != 429 || retry_after == answer.headers.end()) return {};
  int seconds = 0;
  std::from_chars(retry_after->second.data(), retry_after->second.data() + retry_after->second.size(), seconds);
  return std::clamp(std::chrono::seconds(seconds), std::chrono::seconds(1), max_wait);
}

/// Returns a request body that is sent in chunks and calls `sent` after each one.
httplib::ContentProvider chunked_body(const std::string& bytes, const SentCallback& sent) {
  return [&bytes, &sent](std::size_t begin, std::size_t length, httplib::DataSink& sink) {
    const std::size_t chunk = std::min(length, chunk_bytes);
    const bool written = sink.write(bytes.data() + begin, chunk);
    if (written && sent) sent(begin + chunk);
    return written;
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
    client.set_connection_timeout(connect_timeout_seconds);
    client.set_read_timeout(answer_timeout_seconds);
    client.set_write_timeout(answer_timeout_seconds);
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

  /// Returns the answer to `send()`, which is repeated while the server is busy, for up to `retry_timeout`.
  template <class Send>
  Result<HttpAnswer> with_retries(const Send& send) const {
    const auto deadline = std::chrono::steady_clock::now() + retry_timeout;
    for (;;) {
      Result<HttpAnswer> answer = result_of(send());
      const std::chrono::seconds wait = answer ? retry_delay(*answer) : std::chrono::seconds();
      if (wait.count() == 0 || std::chrono::steady_clock::now() + wait > deadline) return answer;
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

Result<Connection> Connection::to(const std::string& server, const std::string& token,
                                  const HttpHeaders& default_headers) {
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
  impl->client.set_default_headers(httplib::Headers(default_headers.begin(), default_headers.end()));
  return Connection(std::move(impl));
}

Result<HttpAnswer> Connection::get(const std::string& path) {
  return impl_->with_retries([&] { return impl_->client.Get(path); });
}

Result<HttpAnswer> Connection::get(const std::string& path, const std::function<bool(std::string_view)>& on_chunk) {
  bool success = false;
  std::string error_body;
  const auto begin = [&](const httplib::Response& response) {
    success = response.status >= 200 && response.status < 300;
    error_body.clear();
    return true;
  };
  const auto receive = [&](const char* data, std::size_t size) {
    if (success) return on_chunk({data, size});
    error_body.append(data, size);
    return true;
  };
  Result<HttpAnswer> answer = impl_->with_retries([&] { return impl_->client.Get(path, begin, receive); });
  if (answer) answer->body = std::move(error_body);
  return answer;
}

Result<HttpAnswer> Connection::post_json(const std::string& path, const std::string& body, const HttpHeaders& headers) {
  const httplib::Headers sent(headers.begin(), headers.end());
  return impl_->with_retries([&] { return impl_->client.Post(path, sent, body, "application/json"); });
}

Result<HttpAnswer> Connection::post_bytes(const std::string& path, const std::string& bytes, const SentCallback& sent) {
  return impl_->with_retries([&] {
    if (bytes.empty()) return impl_->client.Post(path, bytes, bytes_type);
    return impl_->client.Post(path, bytes.size(), chunked_body(bytes, sent), bytes_type);
  });
}

Result<HttpAnswer> Connection::put_bytes(const std::string& path, const std::string& bytes, const SentCallback& sent) {
  return impl_->with_retries([&] {
    if (bytes.empty()) return impl_->client.Put(path, bytes, bytes_type);
    return impl_->client.Put(path, bytes.size(), chunked_body(bytes, sent), bytes_type);
  });
}

Result<HttpAnswer> Connection::remove(const std::string& path) {
  return impl_->with_retries([&] { return impl_->client.Delete(path); });
}

}  // namespace pelage
