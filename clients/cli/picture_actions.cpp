#include <fmt/format.h>

#include "clients/cli/actions.h"
#include "clients/cli/files.h"
#include "clients/cli/print.h"
#include "protocol/json/decode.h"
#include "protocol/json/decode_answers.h"
#include "protocol/json/encode.h"

namespace pelage {

namespace {

std::string header(const HttpAnswer& answer, const char* name) {
  const auto found = answer.headers.find(name);
  return found == answer.headers.end() ? "" : found->second;
}

}  // namespace

ExitCode draw_frame(Session& session) {
  const Options& options = session.options();
  const auto request = decode_frame_query(options.frame);
  if (!request) return report(request.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = Session::accepted(session.connection().post_json(*path + "/frames", encode(*request)));
  if (!answer) return report(answer.status());
  if (const Status status = write_file(options.output, answer->body); !status.ok()) return report(status);
  if (options.output == "-") return done;
  const std::string revision = header(*answer, "pelage-revision"), quality = header(*answer, "pelage-quality");
  if (options.json) {
    fmt::print("{{\"file\":{},\"revision\":{},\"quality\":{},\"server_timing\":{}}}\n", json_text(options.output),
               revision, quality, json_text(header(*answer, "server-timing")));
  } else {
    fmt::print("{}: revision {}, {}\n", options.output, revision, header(*answer, "server-timing"));
  }
  return done;
}

ExitCode pick_pixel(Session& session) {
  const Options& options = session.options();
  const auto view = decode_frame_query(options.frame);
  if (!view) return report(view.status());
  const PickRequest request{.view = {view->camera, view->width, view->height}, .pixel = {options.x, options.y}};
  const std::string body = encode(request);
  if (const auto checked = decode_pick(body); !checked) return report(checked.status());
  const auto path = session.scene_path();
  if (!path) return report(path.status());
  const auto answer = Session::accepted(session.connection().post_json(*path + "/pick", body));
  if (!answer) return report(answer.status());
  const auto pick = decode_pick_answer(answer->body);
  if (!pick) return report(pick.status());
  if (options.json)
    fmt::print("{}\n", answer->body);
  else
    print(*pick);
  return done;
}

}  // namespace pelage
