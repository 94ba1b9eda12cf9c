// One run of the client: the server it talks to, and how it says what happened.
#pragma once

#include <string>

#include "base/status.h"
#include "clients/cli/http/connection.h"
#include "clients/cli/options.h"
#include "clients/cli/terminal/report.h"

namespace pelage {

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

/// Returns a header of an answer; "" when it has none. `name` is in lower case.
std::string header(const HttpAnswer& answer, const char* name);

/// Prints a scene, or why the server did not describe it.
ExitCode print_summary(const Session& session, const Result<HttpAnswer>& answer);

/// Prints what a command changed, or why it was refused; `context` as for report.
ExitCode print_change(const Session& session, const Result<HttpAnswer>& answer, const std::string& context = {});

}  // namespace pelage
