// Answers and what requests say about revisions, in HTTP's words.
#pragma once

#include <httplib.h>

#include <optional>
#include <string>
#include <string_view>

#include "base/status.h"
#include "protocol/commands/answers.h"

namespace pelage {

int http_status_of(Code code);

void reply_json(httplib::Response& response, int http_status, const std::string& body);
/// Answers with JSON, and sets ETag.
void reply_json(httplib::Response& response, int http_status, const std::string& body, Revision revision);

/// Answers with a long body without compression, which would hold up a log of some MB.
void reply_uncompressed(httplib::Response& response, const char* content_type, std::string body);

/// Answers with a problem document, and with Retry-After where trying again helps. Its text is in `reason` too, which
/// cpp-httplib does not send, for the log.
void reply_problem(httplib::Response& response, const Status& status, int http_status);
void reply_problem(httplib::Response& response, const Status& status);

/// The refusal of what a path names by `pointer`, if it is of that: nothing is there.
Status not_found_at(Status refusal, std::string_view pointer);

/// Makes the connection end after this answer, which has a body. cpp-httplib goes on after a header
/// "Connection: close"; it stops when a content provider says false. Needed wherever a request's body was not read,
/// or what is left of it would run as the next request.
void close_after(httplib::Response& response);

/// Returns "12", with the quotes; "12.8" for a traced picture of 8 passes.
std::string etag_of(Revision revision, int passes = 0);
void set_etag(httplib::Response& response, Revision revision, int passes = 0);

/// The revision of If-Match; none without the header and for *. Malformed when it is no single strong entity tag of
/// ours.
Result<std::optional<Revision>> if_match_of(const httplib::Request& request);
/// Returns a parameter that is 0 or 1, and 0 where there is none. Refused (invalid) for anything else.
Result<bool> flag_of(const httplib::Request& request, const std::string& name);
inline Result<bool> is_dry_run(const httplib::Request& request) { return flag_of(request, "dry_run"); }

/// The values of a header that may come in several lines.
std::string joined_header(const httplib::Request& request, const char* name);

/// Returns whether If-None-Match is * or names the entity tag, which has its quotes; weak ones count (RFC 9110 13.1.2).
bool none_match_names(const httplib::Request& request, std::string_view etag);
/// The same for a revision, and the passes of a traced picture.
bool none_match_names(const httplib::Request& request, Revision revision, int passes = 0);

}  // namespace pelage
