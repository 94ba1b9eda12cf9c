#include <chrono>
#include <thread>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "server/export/export_file.h"
#include "server/http/reply.h"
#include "server/http/routes.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

Result<ExportRequest> export_request_of(const Request& request) {
  Query query = query_of(request);
  std::erase_if(query, [](const auto& parameter) { return parameter.first == "dry_run"; });
  query.emplace_back("format", request.matches[2].str());
  Result<ExportRequest> wanted = decode_export_query(query);
  if (!wanted) return not_found_at(wanted.status(), "/format");
  return wanted;
}

/// Enters the gate, or waits up to 5 s for the previous export to leave it: a client has its whole file a moment before
/// its slot is free.
Gate::Pass enter_soon(Gate& gate) {
  constexpr int tries = 100;
  constexpr std::chrono::milliseconds pause(50);
  for (int k = 1; k < tries; ++k) {
    if (Gate::Pass pass = gate.enter()) return pass;
    std::this_thread::sleep_for(pause);
  }
  return gate.enter();
}

/// Sends the file in chunks, and holds the pass until the last one.
void send_file(ExportFile file, Gate::Pass pass, Response& response) {
  const auto shared = std::make_shared<std::pair<ExportFile, Gate::Pass>>(std::move(file), std::move(pass));
  response.set_content_provider(
      shared->first.about.bytes, shared->first.content_type,
      [shared](std::size_t, std::size_t, httplib::DataSink& sink) {
        return shared->first.write([&](std::string_view chunk) { return sink.write(chunk.data(), chunk.size()); });
      });
}

void answer_export(Service& service, const Scene& scene, const Request& request, Response& response) {
  const auto wanted = export_request_of(request);
  if (!wanted) return reply_problem(response, wanted.status());
  const auto dry_run = is_dry_run(request);
  if (!dry_run) return reply_problem(response, dry_run.status());
  Gate::Pass pass = enter_soon(service.exports);
  if (!pass)
    return reply_problem(response, failure(Code::unavailable, "Another file is being exported.", "", "one at a time"));
  const ClientSocket client(request);
  Result<ExportFile> file = export_file(service.scenes, scene, *wanted, cancel_of(client));
  if (!file) return reply_problem(response, file.status());
  if (*dry_run) return reply_json(response, 200, encode(file->about));
  response.status = 200;
  response.set_header("Pelage-Revision", std::to_string(file->about.revision));
  response.set_header("Pelage-Export", encode(file->about));
  response.set_header("Content-Disposition", "attachment; filename=\"groom" + file->ending + "\"");
  send_file(std::move(*file), std::move(pass), response);
}

}  // namespace

void add_export_routes(httplib::Server& server, Service& service) {
  server.Get("/v1/scenes/([^/]+)/export/([^/]+)", [&](const Request& request, Response& response) {
    with_scene(service, request, response,
               [&](const auto& scene) { answer_export(service, *scene, request, response); });
  });
}

}  // namespace pelage
