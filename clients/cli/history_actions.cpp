#include <fmt/format.h>

#include "clients/cli/actions.h"
#include "clients/cli/steps.h"
#include "protocol/json/decode_answers.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

/// What takes the step's place: the commands of the file, all as one step.
Result<AmendRequest> amendment(Session& session, const std::string& path, std::string& place) {
  AmendRequest request{.revision = session.options().count, .commands = {}};
  if (session.options().drop) return request;
  const auto steps = read_steps(session, path, place);
  if (!steps) return steps.status();
  for (const RunStep& step : *steps)
    request.commands.insert(request.commands.end(), step.commands.begin(), step.commands.end());
  return request;
}

}  // namespace

ExitCode amend_step(Session& session) {
  const Options& options = session.options();
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  std::string place = options.file;
  const auto request = amendment(session, *path, place);
  if (!request) return report(request.status(), place);
  HttpHeaders headers;
  if (options.if_match) headers.emplace("If-Match", fmt::format("\"{}\"", *options.if_match));
  const std::string address = *path + "/amend" + (options.dry_run ? "?dry_run=1" : "");
  const auto answer = Session::accepted(session.connection().post_json(address, encode(*request), headers));
  const ExitCode code = print_change(session, answer, options.file);
  if (code == done && options.dry_run && !options.json) fmt::print("nothing is changed\n");
  return code;
}

ExitCode branch_scene(Session& session) {
  const Options& options = session.options();
  const std::string request = encode(BranchRequest{options.name, options.revision});
  if (const auto checked = decode_branch(request); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = Session::accepted(session.connection().post_json(*path + "/branch", request));
  if (!answer) return report(answer.status());
  const auto summary = decode_scene_summary(answer->body);
  if (!summary) return report(summary.status());
  fmt::print("{}\n", options.json ? answer->body : summary->id);
  return done;
}

}  // namespace pelage
