#include "server/http/guard.h"

#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <string>

#include "base/limits.h"
#include "server/http/routes.h"
#include "server/http/transport/http_transport.h"

namespace pelage {

ClientSocket::ClientSocket(const httplib::Request& request) {
  if (const Exchange* exchange = exchange_of(request)) descriptor_ = exchange->connection.socket();
}

bool ClientSocket::gone() const {
  char byte = 0;
  return descriptor_ >= 0 && recv(descriptor_, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

namespace {

using httplib::Request;

// A body a little over the limit is read to its end before it is refused, so that clients which send first and listen
// later see the refusal; a longer one is cut off.
constexpr std::uint64_t drain_factor = 4;  // times the limit

std::uint64_t body_limit_of(const Request& request) {
  return request.path.ends_with("/recipe") ? limits::recipe_bytes : limits::command_body_bytes;
}

Refusal refuse(int http_status, Code code, std::string message, std::string limit = {}) {
  return {http_status, failure(code, std::move(message), "", std::move(limit))};
}

bool is_token_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || (c != '\0' && std::strchr("!#$%&'*+-.^_`|~", c));
}

/// Finds header names with characters that HTTP forbids: cpp-httplib takes "Content-Length ", with its space, for
/// another header, and reads no body for it.
bool has_odd_header_name(const Request& request) {
  return std::any_of(request.headers.begin(), request.headers.end(), [](const auto& header) {
    return header.first.empty() || !std::all_of(header.first.begin(), header.first.end(), is_token_character);
  });
}

std::optional<std::uint64_t> content_length(const Request& request) {
  const std::string text = request.get_header_value("Content-Length");
  std::uint64_t length = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), length);
  if (text.empty() || error != std::errc() || stop != text.data() + text.size()) return {};
  return length;
}

/// The part of an authority before the port: "[::1]" of "[::1]:80".
std::string host_name(const std::string& authority) {
  const std::size_t bracket = authority.find(']');
  const std::size_t colon = authority.find(':', bracket == std::string::npos ? 0 : bracket);
  return authority.substr(0, colon);
}

std::optional<Refusal> refused_framing(const Request& request) {
  if (has_odd_header_name(request)) return refuse(400, Code::malformed, "A header has no proper name.");
  if (request.has_header("Transfer-Encoding")) {
    return refuse(411, Code::malformed, "Bodies come with a Content-Length, not in chunks.", "Content-Length");
  }
  if (request.has_header("Content-Encoding")) {
    return refuse(415, Code::unsupported, "Compressed bodies are not accepted.", "no Content-Encoding");
  }
  const std::size_t lengths = request.get_header_value_count("Content-Length");
  if (lengths > 1) return refuse(400, Code::malformed, "There is more than one Content-Length.", "one");
  if (lengths == 1 && !content_length(request)) {
    return refuse(400, Code::malformed, "Content-Length is no number of bytes.", "digits");
  }
  if (request.get_header_value_count("Range") > 1 || request.ranges.size() > 1) {
    return refuse(416, Code::malformed, "Only one range can be asked for.", "one");
  }
  return {};
}

std::optional<Refusal> refused_body(const Request& request) {
  const std::uint64_t length = content_length(request).value_or(0);
  const std::string type = request.get_header_value("Content-Type");
  if (length == 0) return {};
  const bool opens_file = request.method == "POST" && request.path == "/v1/open";
  if (opens_file && !type.starts_with("application/octet-stream"))  // needs a CORS preflight from other sites
    return refuse(415, Code::unsupported, "A file comes as plain bytes.", "Content-Type: application/octet-stream");
  if (request.method == "PUT" || opens_file) {
    if (length > limits::model_bytes) {
      return refuse(413, Code::too_large, fmt::format("The upload has {} bytes.", length),
                    fmt::format("at most {} bytes", limits::model_bytes));
    }
    if (type.starts_with("multipart/") || type.starts_with("application/x-www-form-urlencoded")) {
      return refuse(415, Code::unsupported, "An upload comes as plain bytes, not as a form.",
                    "application/octet-stream");
    }
    return {};
  }
  if (request.method != "POST") {
    return refuse(400, Code::malformed, "A " + request.method + " has no body.", "Content-Length 0");
  }
  if (const std::uint64_t limit = body_limit_of(request); length > drain_factor * limit) {
    return refuse(413, Code::too_large, fmt::format("The body has {} bytes.", length),
                  fmt::format("at most {} bytes", limit));
  }
  // Only JSON: pages of other sites can send forms and plain text without a CORS preflight.
  if (!type.empty() && !type.starts_with("application/json")) {
    return refuse(415, Code::unsupported, "The body has to be JSON.", "Content-Type: application/json");
  }
  return {};
}

/// Pages and their files need no token, since a browser cannot send one for them. They are the same on every server and
/// hold no secrets. The studio asks for the token and sends it with each of its calls.
bool is_a_page(const std::string& path) {
  return path == "/" || path.starts_with("/assets/") || path == "/docs" || path.starts_with("/docs/");
}

bool needs_no_token(const std::string& path) { return path == "/livez" || path == "/readyz" || is_a_page(path); }

}  // namespace

bool is_loopback_name(const std::string& host) {
  if (host == "localhost" || host == "[::1]" || host == "::1") return true;
  const bool digits = host.find_first_not_of("0123456789.") == std::string::npos;
  return digits && host.starts_with("127.") && std::count(host.begin(), host.end(), '.') == 3;
}

Guard::Guard(std::string token, std::vector<std::string> hosts, bool any_host)
    : token_(std::move(token)), hosts_(std::move(hosts)), any_host_(any_host) {}

bool Guard::is_our_name(const std::string& host) const {
  return any_host_ || is_loopback_name(host) || std::find(hosts_.begin(), hosts_.end(), host) != hosts_.end();
}

bool Guard::has_token(const Request& request) const {
  const std::string given = request.get_header_value("Authorization");
  const std::string wanted = "Bearer " + token_;
  // Compares every byte, so that the time taken does not reveal how many match.
  unsigned difference = given.size() == wanted.size() ? 0 : 1;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    difference |= static_cast<unsigned char>(wanted[i] ^ (i < given.size() ? given[i] : '\0'));
  }
  return difference == 0;
}

std::optional<Refusal> Guard::refused_sender(const Request& request) const {
  const std::string host = request.get_header_value("Host");
  if (host.empty() || request.get_header_value_count("Host") != 1) {
    return refuse(400, Code::malformed, "A request names one Host.", "one");
  }
  // A page of another site can reach a loopback server under a name of its own (DNS rebinding).
  if (!is_our_name(host_name(host))) {
    return refuse(403, Code::malformed, "This server is not known under the name of the Host header.");
  }
  const std::string origin = request.get_header_value("Origin");
  if (!origin.empty() && origin != "http://" + host && origin != "https://" + host) {
    return refuse(403, Code::malformed, "Requests from pages of other sites are refused.");
  }
  if (!token_.empty() && !needs_no_token(request.path) && !has_token(request)) {
    return refuse(401, Code::malformed, "A token is needed.", "Authorization: Bearer TOKEN");
  }
  return {};
}

std::optional<Refusal> Guard::refusal(const Request& request) const {
  static constexpr std::string_view methods[] = {"GET", "HEAD", "POST", "PUT", "DELETE"};
  if (std::find(std::begin(methods), std::end(methods), request.method) == std::end(methods)) {
    const std::string used = route_of(request.path).methods;
    return refuse(405, Code::malformed, "This address does not take the method.",
                  used.empty() ? "GET, HEAD, POST, PUT, DELETE" : used);
  }
  if (auto refusal = refused_framing(request)) return refusal;
  if (auto refusal = refused_sender(request)) return refusal;
  return refused_body(request);
}

}  // namespace pelage
