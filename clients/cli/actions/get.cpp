#include <cstdio>

#include "clients/cli/actions/actions.h"
#include "clients/cli/terminal/files.h"

namespace pelage {

namespace {

/// Returns the URL path: the first argument if it is the only one ("/metrics"), else the second one below the scene
/// that the first one names.
Result<std::string> whole_address(Session& session) {
  const Options& options = session.options();
  if (options.address.empty()) return options.scene;
  const Result<std::string> scene = session.scene_path();
  if (!scene) return scene;
  return *scene + (options.address.starts_with("/") ? "" : "/") + options.address;
}

bool print_piece(std::string_view piece) {
  return std::fwrite(piece.data(), 1, piece.size(), stdout) == piece.size() && std::fflush(stdout) == 0;
}

ExitCode get_into_file(Session& session, const std::string& address) {
  NewFile file(session.options().answer);
  bool written = true;
  const auto answer =
      session.connection().get(address, [&](std::string_view piece) { return written = file.write(piece); });
  if (written) {  // otherwise keep() below reports the file error
    const auto accepted = Session::accepted(answer);
    if (!accepted) return report(accepted.status());
  }
  const Status kept = file.keep();
  return kept.ok() ? done : report(kept);
}

}  // namespace

ExitCode get_address(Session& session) {
  const Options& options = session.options();
  if (options.address.empty() && !options.scene.starts_with("/"))
    return report(failure(Code::invalid, "An address begins with /; one of a scene comes after the scene.", "",
                          "as /metrics, or fox settings"));
  const Result<std::string> address = whole_address(session);
  if (!address) return report(address.status());
  if (options.answer != "-") return get_into_file(session, *address);
  const auto answer = Session::accepted(session.connection().get(*address, print_piece));
  return answer ? done : report(answer.status());
}

}  // namespace pelage
