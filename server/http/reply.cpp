#include "server/http/reply.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>

#include "protocol/json/encode.h"

namespace pelage {

int http_status_of(Code code) {
  switch (code) {
    case Code::ok: return 200;
    case Code::malformed: return 400;
    case Code::not_found: return 404;
    case Code::conflict: return 409;
    case Code::precondition: return 412;
    case Code::too_large: return 413;
    case Code::unsupported: return 415;
    case Code::invalid: return 422;
    case Code::busy: return 429;
    case Code::internal: return 500;
    case Code::unavailable: return 503;
  }
  return 500;
}

void reply_json(httplib::Response& response, int http_status, const std::string& body) {
  response.status = http_status;
  response.set_content(body, "application/json");
}

void reply_json(httplib::Response& response, int http_status, const std::string& body, Revision revision) {
  reply_json(response, http_status, body);
  set_etag(response, revision);
}

void reply_uncompressed(httplib::Response& response, const char* content_type, std::string body) {
  response.status = 200;
  if (body.empty()) return response.set_content(body, content_type);  // a content provider of 0 bytes would never end
  const auto shared_body = std::make_shared<const std::string>(std::move(body));
  response.set_content_provider(shared_body->size(), content_type,
                                [shared_body](size_t from, size_t size, httplib::DataSink& sink) {
                                  return sink.write(shared_body->data() + from, size);
                                });
}

/// Returns message, pointer and limit in one line.
static std::string words_of(const Status& status) {
  std::string words = status.message;
  for (const std::string& more : {status.pointer, status.limit}) words += (more.empty() ? "" : " ") + more;
  return words;
}

void reply_problem(httplib::Response& response, const Status& status, int http_status) {
  response.status = http_status;
  response.reason = words_of(status);
  response.set_content(encode_problem(status, http_status), "application/problem+json");
  if (http_status == 429 || http_status == 503) response.set_header("Retry-After", "1");
}

void reply_problem(httplib::Response& response, const Status& status) {
  reply_problem(response, status, http_status_of(status.code));
}

Status not_found_at(Status refusal, std::string_view pointer) {
  if (refusal.pointer == pointer) refusal.code = Code::not_found;
  return refusal;
}

void close_after(httplib::Response& response) {
  const auto body = std::make_shared<const std::string>(std::move(response.body));
  const std::string type = response.get_header_value("Content-Type");
  response.body.clear();
  response.headers.erase("Content-Type");
  response.set_header("Connection", "close");
  response.set_content_provider(body->size(), type, [body](std::size_t offset, std::size_t, httplib::DataSink& sink) {
    sink.write(body->data() + offset, body->size() - offset);
    return false;
  });
}

std::string etag_of(Revision revision, int passes) {
  return passes > 0 ? fmt::format("\"{}.{}\"", revision, passes) : fmt::format("\"{}\"", revision);
}

void set_etag(httplib::Response& response, Revision revision, int passes) {
  response.set_header("ETag", etag_of(revision, passes));
}

Result<bool> flag_of(const httplib::Request& request, const std::string& name) {
  if (!request.has_param(name)) return false;
  const std::string value = request.get_param_value(name);
  if (value == "1" || value == "true") return true;
  if (value == "0" || value == "false") return false;
  return failure(Code::invalid, name + " is true or false.", "/" + name, "1 | true | 0 | false");
}

Result<std::optional<Revision>> if_match_of(const httplib::Request& request) {
  const std::string text = request.get_header_value("If-Match");
  if (text.empty() || text == "*") return std::optional<Revision>();
  Revision revision = 0;
  const char* end = text.data() + text.size();
  if (text.size() >= 3 && text.front() == '"' && text.back() == '"') {
    const auto [stop, error] = std::from_chars(text.data() + 1, end - 1, revision);
    if (error == std::errc() && stop == end - 1) return std::optional(revision);
  }
  return failure(Code::malformed, "If-Match is no entity tag of a scene.", "", "one ETag such as \"12\", or *");
}

std::string joined_header(const httplib::Request& request, const char* name) {
  std::string joined;
  for (std::size_t k = 0; k < request.get_header_value_count(name); ++k) {
    joined += (k > 0 ? "," : "") + request.get_header_value(name, k);
  }
  return joined;
}

bool if_none_match_lists(const httplib::Request& request, std::string_view etag) {
  const std::string header = request.get_header_value("If-None-Match");
  std::string_view left = header;
  while (!left.empty()) {
    const std::size_t end = std::min(left.find(','), left.size());
    std::string_view tag = left.substr(0, end);
    while (tag.starts_with(' ')) tag.remove_prefix(1);
    while (tag.ends_with(' ')) tag.remove_suffix(1);
    if (tag.starts_with("W/")) tag.remove_prefix(2);
    if (tag == etag || tag == "*") return true;
    left.remove_prefix(std::min(end + 1, left.size()));
  }
  return false;
}

bool if_none_match_lists(const httplib::Request& request, Revision revision, int passes) {
  return if_none_match_lists(request, etag_of(revision, passes));
}

}  // namespace pelage
