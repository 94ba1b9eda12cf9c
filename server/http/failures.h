// What goes wrong, as answers.
#pragma once

#include <httplib.h>

#include "server/http/guard.h"

namespace pelage {

/// Answers with a refusal and ends the connection, since its request may not be read to the end.
void refuse(const Refusal& refusal, const httplib::Request& request, httplib::Response& response);

/// What cpp-httplib refuses by itself and what handlers throw become problem documents too. Each 500 names its request,
/// as the log does, and exchange_of(request)->problem says what was thrown.
void answer_failures(httplib::Server& server);

}  // namespace pelage
