// One run of the client: the server it talks to, and how it says what happened.
#pragma once

#include <string>

#include "clients/cli/http/connection.h"
#include "clients/cli/options.h"
#include "protocol/base/status.h"

namespace pelage {

enum ExitCode { done = 0, failed = 1, wrong_use = 2, refused = 3 };

/// Prints the reason, where, the limit, the nearest name and what to do next, to standard error: what the status says,
/// or what fits its code. `context` says what
/// was being done, such as "step 3 of groom.jsonl". Gives the exit code that fits.
ExitCode report(const Status& status, const std::string& context = {});

class Session {
 public:
  Session(Connection connection, const Options& options) : connection_(std::move(connection)), options_(options) {}

  Connection& connection() { return connection_; }
  const Options& options() const { return options_; }

  /// Turns problem documents into their Status.
  static Result<HttpAnswer> accepted(Result<HttpAnswer> answer);

  /// Sends what makes a scene. Refused (busy) when the server holds as many as it can.
  Result<HttpAnswer> make_scene(const std::string& address, const std::string& request);

  /// "/v1/scenes/ID" of the scene that the user named by id or, when only one has it, by name.
  Result<std::string> scene_path();
  /// The id of a scene that is named by id or, when only one has it, by name.
  Result<std::string> scene_id(const std::string& wanted);

 private:
  Connection connection_;
  const Options& options_;
};

/// Of an answer; "" when it has none. `name` in lower case.
std::string header(const HttpAnswer& answer, const char* name);

/// Prints what a command changed, or what refused it; `context` as for report.
ExitCode print_change(const Session& session, const Result<HttpAnswer>& answer, const std::string& context = {});

}  // namespace pelage
