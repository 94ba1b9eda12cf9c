#include "server/http/failures.h"

#include <fmt/format.h>

#include <exception>
#include <string>

#include "server/http/reply.h"
#include "server/http/routes.h"
#include "server/http/transport/http_transport.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

/// Refusals of cpp-httplib itself, which have no body. What it did not read may follow, so the connection ends.
Refusal own_refusal(const Request& request, int http_status) {
  const RouteInfo route = route_of(request.path);
  if (http_status == 404 && !route.methods.empty()) {
    return {405, failure(Code::malformed, "This address does not take the method.", "", route.methods)};
  }
  if (http_status == 404) return {404, failure(Code::not_found, "There is nothing at this address.")};
  if (http_status == 413) return {413, failure(Code::too_large, "The body is too large.")};
  if (http_status == 500) return {500, failure(Code::internal, "The server failed.")};
  return {http_status, failure(Code::malformed, "The request is not what HTTP says.")};
}

Status naming_request(std::string message, const Request& request) {
  if (const Exchange* exchange = exchange_of(request))
    message += fmt::format(" The server's log says more at request {}.", exchange->id);
  return failure(Code::internal, std::move(message));
}

void complete_failure(const Request& request, Response& response) {
  const bool ours = !response.body.empty() || response.content_length_ > 0;
  Refusal refusal = own_refusal(request, response.status);
  if (response.status == 500) refusal.status = naming_request(ours ? response.reason : refusal.status.message, request);
  if (!ours) return refuse(refusal, request, response);
  if (response.status == 500) reply_problem(response, refusal.status);
}

std::string words_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "Something was thrown that is no exception.";
  }
}

}  // namespace

void refuse(const Refusal& refusal, const Request& request, Response& response) {
  auto& owned = const_cast<Request&>(request);
  owned.ranges.clear();
  // No body is written for a HEAD, so that close_after would not close; it is answered as a GET.
  if (request.method == "HEAD") owned.method = "GET";
  reply_problem(response, refusal.status, refusal.http_status);
  if (refusal.http_status == 401) response.set_header("WWW-Authenticate", "Bearer");
  if (refusal.http_status == 405) response.set_header("Allow", "GET, HEAD, POST, PUT, DELETE");
  close_after(response);
}

void answer_failures(httplib::Server& server) {
  server.set_error_handler(complete_failure);
  // NOLINTNEXTLINE(performance-unnecessary-value-param): the signature is httplib's
  server.set_exception_handler([](const Request& request, Response& response, std::exception_ptr thrown) {
    if (Exchange* exchange = exchange_of(request)) exchange->problem = words_of(thrown);
    response = {};  // complete_failure makes the answer
    response.version = "HTTP/1.1";
    response.status = 500;
  });
}

}  // namespace pelage
