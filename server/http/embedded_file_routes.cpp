#include "server/http/accept_encoding.h"
#include "server/http/embedded_files.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

std::string_view bytes_of(const EmbeddedFile& file, ContentCoding encoding) {
  return encoding == ContentCoding::brotli ? file.brotli : encoding == ContentCoding::gzip ? file.gzip : file.identity;
}

/// Restricts a page to its own files: no other site can frame it, see where its users come from or inject a script.
void set_security_headers(Response& response) {
  response.set_header(
      "Content-Security-Policy",
      "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; media-src blob:; "
      "connect-src 'self'; font-src 'self'; worker-src 'self'; base-uri 'none'; form-action 'none'; "
      "frame-ancestors 'none'");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cross-Origin-Opener-Policy", "same-origin");
  response.set_header("Permissions-Policy", "camera=(), geolocation=(), microphone=(), payment=(), usb=()");
}

/// Sends bytes that are compressed already; cpp-httplib would compress them again if they were given to set_content.
void send(std::string_view bytes, std::string_view type, Response& response) {
  response.set_content_provider(bytes.size(), std::string(type),
                                [bytes](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                  return sink.write(bytes.data() + offset, length);
                                });
}

void answer_file(const EmbeddedFile& file, const Request& request, Response& response) {
  response.set_header("Vary", "Accept-Encoding");
  const auto encoding =
      choose_encoding(joined_header(request, "Accept-Encoding"), !file.gzip.empty(), !file.brotli.empty());
  if (!encoding) {
    const Status refused = failure(Code::malformed, "No encoding of this file is accepted.", "", "br, gzip, identity");
    return reply_problem(response, refused, 406);
  }
  const std::string_view name = name_of(*encoding);
  const std::string etag = "\"" + std::string(file.etag) + (name.empty() ? "" : "-") + std::string(name) + "\"";
  response.set_header("ETag", etag);
  response.set_header("Cache-Control", file.hashed ? "public, max-age=31536000, immutable" : "no-cache");
  set_security_headers(response);
  response.status = if_none_match_lists(request, etag) ? 304 : 200;
  if (response.status == 304) return;
  if (!name.empty()) response.set_header("Content-Encoding", std::string(name));
  send(bytes_of(file, *encoding), file.type, response);
}

void answer_address(const Request& request, Response& response) {
  if (const EmbeddedFile* file = find_embedded_file(request.path)) return answer_file(*file, request, response);
  response.set_header("Cache-Control", "no-store");  // a later version of the server may have it
  reply_problem(response, failure(Code::not_found, "The server has no such file."));
}

/// Redirects /docs and /docs/ to the first page. All links between the pages are relative, as this one is, so that a
/// proxy may put them under another path.
void answer_first_page(const Request& request, Response& response) {
  response.set_header("Location", request.path.ends_with('/') ? "index.html" : "docs/index.html");
  response.status = 308;
}

}  // namespace

void add_embedded_file_routes(httplib::Server& server) {
  server.Get("/", answer_address);
  server.Get("/openapi.json", answer_address);
  server.Get("/assets/([^/]+)", answer_address);
  server.Get("/docs/?", answer_first_page);
  server.Get("/docs/([^/]+)", answer_address);
}

}  // namespace pelage
