// What goes wrong, as answers.
#pragma once

#include <httplib.h>

#include "server/http/guard.h"

namespace pelage {

/// Answers with a refusal and ends the connection, since its request may not be read to the end.
void refuse(const Refusal& refusal, const httplib::Request& request, httplib::Response& response);

/// What cpp-httplib refuses by itself and what handlers throw become problem documents too: 503 where memory ran out,
/// else 500. Each 500 names its request, as the log does.
void answer_failures(httplib::Server& server);

}  // namespace pelage
