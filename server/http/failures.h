// Answers to requests that are refused or fail.
#pragma once

#include <httplib.h>

#include "server/http/guard.h"

namespace pelage {

/// Answers with a refusal and ends the connection, since the request may not have been read to its end.
void refuse(const Refusal& refusal, const httplib::Request& request, httplib::Response& response);

/// Makes problem documents of cpp-httplib's own refusals and of exceptions that handlers throw: 503 if memory ran out,
/// else 500. Each 500 names the id of its request in the log.
void answer_failures(httplib::Server& server);

}  // namespace pelage
