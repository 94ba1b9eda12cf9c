#include "server/http/failures.h"

#include <fmt/format.h>

#include <exception>
#include <string>

#include "base/caught.h"
#include "server/http/reply.h"
#include "server/http/routes.h"
#include "server/http/transport/http_transport.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

/// Returns the problem for a refusal by cpp-httplib itself, which has only a status.
Refusal own_refusal(const Request& request, int http_status) {
  const RouteInfo route = route_of(request.path);
  if (http_status == 404 && !route.methods.empty()) {
    return {405, failure(Code::malformed, "This address does not take the method.", "", route.methods)};
  }
  if (http_status == 404) return {404, failure(Code::not_found, "There is nothing at this address.")};
  if (http_status == 413) return {413, failure(Code::too_large, "The body is too large.")};
  return {http_status, failure(Code::malformed, "The request is not valid HTTP.")};
}

/// Adds the id of the request to the message of an internal failure.
Status named(Status status, const Request& request) {
  const Exchange* exchange = exchange_of(request);
  if (status.code == Code::internal && exchange)
    status.message += fmt::format(" The server's log says more at request {}.", exchange->id);
  return status;
}

void complete_failure(const Request& request, Response& response) {
  if (response.status == 500 && !response.body.empty())
    return reply_problem(response, named(failure(Code::internal, response.reason), request));
  const bool ours = !response.body.empty() || response.content_length_ > 0;
  if (!ours) refuse(own_refusal(request, response.status), request, response);
}

/// Answers an exception and ends the connection, since the request may not have been read to its end.
void answer_thrown(const Request& request, Response& response, const Status& status) {
  if (Exchange* exchange = exchange_of(request)) exchange->problem = status.message;
  response = {};
  response.version = "HTTP/1.1";
  refuse({http_status_of(status.code), named(status, request)}, request, response);
}

}  // namespace

void refuse(const Refusal& refusal, const Request& request, Response& response) {
  auto& owned = const_cast<Request&>(request);
  owned.ranges.clear();
  // A HEAD is answered as a GET: close_after only closes after a body, and a HEAD gets none.
  if (request.method == "HEAD") owned.method = "GET";
  reply_problem(response, refusal.status, refusal.http_status);
  if (refusal.http_status == 401) response.set_header("WWW-Authenticate", "Bearer");
  if (refusal.http_status == 405) response.set_header("Allow", refusal.status.limit);
  close_after(response);
}

void answer_failures(httplib::Server& server) {
  server.set_error_handler(complete_failure);
  // NOLINTNEXTLINE(performance-unnecessary-value-param): the signature is httplib's
  server.set_exception_handler([](const Request& request, Response& response, std::exception_ptr thrown) {
    answer_thrown(request, response, status_of(thrown));
  });
}

}  // namespace pelage
