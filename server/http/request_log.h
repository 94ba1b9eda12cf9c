// Makes the ids of requests, and writes a log line for each request.
#pragma once

#include <string>

#include "server/http/transport/connection.h"
#include "server/log/server_log.h"

namespace pelage {

inline constexpr const char* request_id_header = "Pelage-Request";

/// Returns a new id for a request, used in its answer and in the log: 16 random hex digits. If the header traceparent
/// (W3C Trace Context) has a trace id, that and "-" come first, so that one can search the log for a trace.
std::string new_request_id(const std::string& traceparent);

/// Logs a failure (5xx) as an error, a refusal (4xx) as a warning and anything else as information.
void log_exchange(const ServerLog& log, const Exchange& exchange);

}  // namespace pelage
