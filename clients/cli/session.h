// One run of the client: its connection to the server, and helpers that print the server's answers.
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

  /// Converts an error answer (a problem document) into its Status; returns other answers unchanged.
  static Result<HttpAnswer> accepted(Result<HttpAnswer> answer);

  /// Sends a request that creates a scene. If the server holds its maximum of scenes, the error advises to remove one.
  Result<HttpAnswer> make_scene(const std::string& address, const std::string& request);

  /// Returns "/v1/scenes/ID" for the scene that the user named by its id or by a unique name.
  Result<std::string> scene_path();
  /// Returns the id of a scene that is given by its id or by a unique name.
  Result<std::string> scene_id(const std::string& wanted);

 private:
  Connection connection_;
  const Options& options_;
};

/// Returns a header of an answer; "" if it is absent. `name` is in lower case.
std::string header(const HttpAnswer& answer, const char* name);

/// Prints a scene's summary, or the error.
ExitCode print_summary(const Session& session, const Result<HttpAnswer>& answer);

/// Prints what a command changed, or the error; `context` as in report().
ExitCode print_change(const Session& session, const Result<HttpAnswer>& answer, const std::string& context = {});

}  // namespace pelage
