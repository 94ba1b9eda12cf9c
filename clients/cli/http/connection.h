// An HTTP client for one server.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "base/status.h"

namespace pelage {

struct HttpAnswer {
  int status = 0;
  std::string body;
  std::map<std::string, std::string> headers;  // names in lower case
};

using HttpHeaders = std::map<std::string, std::string>;
using SentCallback = std::function<void(std::size_t bytes)>;

/// Keeps one connection to a server open. Requests fail (unavailable) if the server cannot be reached. A request that a
/// busy server refuses (429) had no effect; it is sent again as Retry-After says, for up to a minute.
class Connection {
 public:
  /// `server` is "http://host:port"; fails (invalid) if it is anything else. `token` may be empty. The headers
  /// `default_headers` are sent with every request.
  static Result<Connection> to(const std::string& server, const std::string& token,
                               const HttpHeaders& default_headers = {});
  ~Connection();
  Connection(Connection&&) noexcept;
  Connection& operator=(Connection&&) noexcept;

  Result<HttpAnswer> get(const std::string& path);
  /// Passes the body of a successful answer (2xx) to `on_chunk` in chunks instead of returning it. The transfer ends if
  /// `on_chunk` returns false.
  Result<HttpAnswer> get(const std::string& path, const std::function<bool(std::string_view)>& on_chunk);
  Result<HttpAnswer> post_json(const std::string& path, const std::string& body, const HttpHeaders& headers = {});
  /// Calls `sent` with the number of bytes sent so far.
  Result<HttpAnswer> post_bytes(const std::string& path, const std::string& bytes, const SentCallback& sent = {});
  Result<HttpAnswer> put_bytes(const std::string& path, const std::string& bytes, const SentCallback& sent = {});
  Result<HttpAnswer> remove(const std::string& path);

 private:
  struct Impl;
  explicit Connection(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
