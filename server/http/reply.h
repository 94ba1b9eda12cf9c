// Writes HTTP answers, and reads the entity tags and flags of requests.
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
/// Answers with JSON, and sets ETag to the revision.
void reply_json(httplib::Response& response, int http_status, const std::string& body, Revision revision);

/// Answers with a long body, uncompressed: compression would delay a log of some MB.
void reply_uncompressed(httplib::Response& response, const char* content_type, std::string body);

/// Answers with a problem document, and with Retry-After where trying again helps (429, 503). For the log its text also
/// goes into `response.reason`, which cpp-httplib does not send.
void reply_problem(httplib::Response& response, const Status& status, int http_status);
void reply_problem(httplib::Response& response, const Status& status);

/// Turns a refusal of the parameter at `pointer`, a part of the path, into not_found. Returns others unchanged.
Status not_found_at(Status refusal, std::string_view pointer);

/// Ends the connection after this answer, which must have a body. Needed wherever a request's body was not read: the
/// rest of it would be taken for the next request. cpp-httplib does not close for a header "Connection: close"; it does
/// when a content provider returns false.
void close_after(httplib::Response& response);

/// Returns "12", with the quotes; "12.8" for a traced picture of 8 passes.
std::string etag_of(Revision revision, int passes = 0);
void set_etag(httplib::Response& response, Revision revision, int passes = 0);

/// Returns the revision of If-Match; none without the header and for *. Fails (malformed) if it is not a single strong
/// entity tag of a revision.
Result<std::optional<Revision>> if_match_of(const httplib::Request& request);
/// Returns a parameter that is 0, false, 1 or true; false without it. Fails (invalid) for anything else.
Result<bool> flag_of(const httplib::Request& request, const std::string& name);
inline Result<bool> is_dry_run(const httplib::Request& request) { return flag_of(request, "dry_run"); }

/// Returns the values of a header that may occur several times, joined by commas.
std::string joined_header(const httplib::Request& request, const char* name);

/// Returns whether If-None-Match is * or lists `etag`, given with its quotes; weak tags match (RFC 9110 13.1.2).
bool if_none_match_lists(const httplib::Request& request, std::string_view etag);
/// The same for a revision and the number of passes of a traced picture.
bool if_none_match_lists(const httplib::Request& request, Revision revision, int passes = 0);

}  // namespace pelage
