// Converts refusals to RFC 9457 problem documents, and back.
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "protocol/json/write.h"

namespace pelage {

namespace {

/// How a code appears in a problem document: the end of its `type`, and the `title`.
struct ProblemType {
  Code code;
  const char *name, *title;
};

constexpr ProblemType types[] = {{Code::internal, "internal", "The server failed"},
                                 {Code::malformed, "malformed", "The request cannot be read"},
                                 {Code::not_found, "not-found", "There is nothing of that name"},
                                 {Code::conflict, "conflict", "The request is at odds with another"},
                                 {Code::precondition, "precondition", "The scene is at another revision"},
                                 {Code::too_large, "too-large", "The body is too large"},
                                 {Code::unsupported, "unsupported", "The body has a form that is not read here"},
                                 {Code::invalid, "invalid", "The request breaks the contract"},
                                 {Code::busy, "busy", "Too much is going on"},
                                 {Code::unavailable, "unavailable", "Not possible now"}};

std::string text_of(const ProblemType& type) { return std::string("urn:pelage:problem:") + type.name; }

const ProblemType& type_of(Code code) {
  for (const ProblemType& type : types) {
    if (type.code == code) return type;
  }
  return types[0];
}

/// Returns the title of a refusal at the level of HTTP, whose type is about:blank; null for any other status.
const char* http_title(int http_status) {
  switch (http_status) {
    case 401: return "Unauthorized";
    case 403: return "Forbidden";
    case 405: return "Method Not Allowed";
    case 408: return "Request Timeout";
    case 411: return "Length Required";
    case 416: return "Range Not Satisfiable";
    case 431: return "Request Header Fields Too Large";
    default: return nullptr;
  }
}

}  // namespace

std::string encode_problem(const Status& status, int http_status) {
  const ProblemType& type = type_of(status.code);
  const char* title = http_title(http_status);
  Problem problem{.type = title ? "about:blank" : text_of(type),
                  .title = title ? title : type.title,
                  .status = http_status,
                  .detail = status.message,
                  .limit = status.limit,
                  .nearest = status.nearest};
  if (!status.pointer.empty() || http_status == 422) problem.pointer = status.pointer;
  return encode(problem);
}

Status decode_problem(std::string_view text) {
  const Result<Problem> problem = decode_answer<Problem>(text);
  if (!problem) return problem.status();
  Code code = Code::internal;
  for (const ProblemType& type : types) {
    if (text_of(type) == problem->type) code = type.code;
  }
  return {.code = code,
          .message = problem->detail,
          .pointer = problem->pointer.value_or(""),
          .limit = problem->limit,
          .nearest = problem->nearest};
}

}  // namespace pelage
