// The client's side of HTTP.
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
using Sent = std::function<void(std::size_t bytes)>;

/// Keeps one connection to a server open. A server that cannot be reached gives a Status (unavailable). One that is
/// busy (429) is asked again when it says so, for a minute; it has done nothing so far.
class Connection {
 public:
  /// `server`: "http://host:port". Refused (invalid) when it is anything else. `token` may be empty;
  /// `always` goes with every request.
  static Result<Connection> to(const std::string& server, const std::string& token, const HttpHeaders& always = {});
  ~Connection();
  Connection(Connection&&) noexcept;
  Connection& operator=(Connection&&) noexcept;

  Result<HttpAnswer> get(const std::string& path);
  /// Does the same, but hands the body of a success (2xx) to `take` in chunks; if `take` returns false, the transfer
  /// ends.
  Result<HttpAnswer> get(const std::string& path, const std::function<bool(std::string_view)>& take);
  Result<HttpAnswer> post_json(const std::string& path, const std::string& body, const HttpHeaders& headers = {});
  /// `sent` is told how many bytes went out so far.
  Result<HttpAnswer> post_bytes(const std::string& path, const std::string& bytes, const Sent& sent = {});
  Result<HttpAnswer> put_bytes(const std::string& path, const std::string& bytes, const Sent& sent = {});
  Result<HttpAnswer> remove(const std::string& path);

 private:
  struct Impl;
  explicit Connection(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
