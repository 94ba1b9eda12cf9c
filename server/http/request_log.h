// The line that the log has for each request.
#pragma once

#include <string>

#include "server/http/transport/connection.h"
#include "server/log/server_log.h"

namespace pelage {

inline constexpr const char* request_id_header = "Pelage-Request";

/// Returns the id of a request in its answer and in the log: 16 random hex digits. The trace id and "-" come first
/// where the header traceparent has one (W3C Trace Context), so that the lines of a trace are found by it.
std::string new_request_id(const std::string& traceparent);

/// A failure (5xx) is an error there, a refusal (4xx) a warning.
void log_exchange(const ServerLog& log, const Exchange& exchange);

}  // namespace pelage
