#include <cstdio>

#include "clients/cli/actions/actions.h"
#include "clients/cli/terminal/files.h"

namespace pelage {

namespace {

/// Returns the URL path: the first argument if it is the only one ("/metrics"), else the second one below the scene
/// that the first one names.
Result<std::string> url_path_of(Session& session) {
  const Options& options = session.options();
  if (options.address.empty()) return options.scene;
  const Result<std::string> scene = session.scene_path();
  if (!scene) return scene;
  return *scene + (options.address.starts_with("/") ? "" : "/") + options.address;
}

bool print_chunk(std::string_view chunk) {
  return std::fwrite(chunk.data(), 1, chunk.size(), stdout) == chunk.size() && std::fflush(stdout) == 0;
}

ExitCode get_into_file(Session& session, const std::string& address) {
  NewFile file(session.options().answer);
  bool written = true;
  const auto answer =
      session.connection().get(address, [&](std::string_view chunk) { return written = file.write(chunk); });
  if (written) {  // otherwise commit() below reports the file error
    const auto accepted = Session::accepted(answer);
    if (!accepted) return report(accepted.status());
  }
  const Status status = file.commit();
  return status.ok() ? done : report(status);
}

}  // namespace

ExitCode get_address(Session& session) {
  const Options& options = session.options();
  if (options.address.empty() && !options.scene.starts_with("/"))
    return report(failure(Code::invalid, "An address begins with / unless it follows a scene.", "",
                          "as /metrics, or fox settings"));
  const Result<std::string> address = url_path_of(session);
  if (!address) return report(address.status());
  if (options.answer != "-") return get_into_file(session, *address);
  const auto answer = Session::accepted(session.connection().get(*address, print_chunk));
  return answer ? done : report(answer.status());
}

}  // namespace pelage
