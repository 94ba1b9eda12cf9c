#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <span>

#include "base/limits.h"
#include "protocol/json/encode.h"
#include "server/export/export_file.h"
#include "server/http/reply.h"
#include "server/http/routes.h"
#include "server/scene/model.h"

namespace pelage {

namespace {

using httplib::Request;
using httplib::Response;

struct Upload {
  std::span<const std::byte> bytes;
  Cancel cancel;
};

/// Returns whether the scene has a groom. Subdivisions, turns and new versions of a model start an empty log, and leave
/// an entry in `subdivisions` that stands for the groom before it.
bool is_groomed(const Scene& scene) { return !scene.effective_log().empty() || !scene.model()->subdivisions.empty(); }

/// Loads the model without losing a groom, not even one made by commands that arrive while its bytes are read.
Result<SceneSummary> load_preserving_groom(Service& service, Scene& scene, const ImportOptions& options,
                                           std::span<const std::byte> bytes, const ExecuteOptions& execute) {
  ExecuteOptions as_now = execute;
  if (!as_now.if_match) as_now.if_match = scene.revision();
  if (is_groomed(scene)) return service.scenes.load_version(scene, options, bytes, execute);
  auto summary = service.scenes.load_model(scene, options, bytes, as_now);
  const bool groomed_meanwhile = !summary && summary.status().code == Code::precondition && !execute.if_match;
  return groomed_meanwhile ? service.scenes.load_version(scene, options, bytes, execute) : summary;
}

void load_model(Service& service, Scene& scene, const Request& request, Response& response, const Upload& file) {
  Query query = query_of(request);
  std::erase_if(query, [](const auto& parameter) { return parameter.first == "discard"; });
  const auto options = decode_import_query(query);
  if (!options) return reply_problem(response, options.status());
  const auto if_match = if_match_of(request);
  if (!if_match) return reply_problem(response, if_match.status());
  const auto discard = flag_of(request, "discard");
  if (!discard) return reply_problem(response, discard.status());
  const std::uint64_t old_model = model_id_of(scene);
  const ExecuteOptions execute{.if_match = *if_match, .cancel = file.cancel};
  const auto summary = *discard ? service.scenes.load_model(scene, *options, file.bytes, execute)
                                : load_preserving_groom(service, scene, *options, file.bytes, execute);
  if (!summary) return reply_problem(response, summary.status());
  service.frames.forget(old_model);
  reply_json(response, 200, encode(*summary), summary->revision);
}

void load_environment(Service& service, Scene& scene, const Request& request, Response& response, const Upload& file) {
  const auto how = decode_environment_query(query_of(request));
  if (!how) return reply_problem(response, how.status());
  auto options = change_options_of(request);
  if (!options) return reply_problem(response, options.status());
  options->cancel = file.cancel;
  const auto answer = service.scenes.load_environment(scene, *how, file.bytes, *options);
  if (!answer) return reply_problem(response, answer.status());
  reply_json(response, 200, encode(*answer), answer->revision);
}

void load_skin_texture(Service& service, Scene& scene, const Request& request, Response& response, const Upload& file) {
  if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
  auto options = change_options_of(request);
  if (!options) return reply_problem(response, options.status());
  options->cancel = file.cancel;
  const auto answer = service.scenes.load_skin_texture(scene, file.bytes, *options);
  if (!answer) return reply_problem(response, answer.status());
  reply_json(response, 200, encode(*answer), answer->revision);
}

void load_map(Service& service, Scene& scene, const Request& request, Response& response, const Upload& file) {
  const auto how = decode_map_upload_query(map_query_of(request));
  if (!how) return reply_problem(response, not_found_at(how.status(), "/field"));
  auto options = change_options_of(request);
  if (!options) return reply_problem(response, options.status());
  options->cancel = file.cancel;
  const auto answer = service.scenes.load_map(scene, *how, file.bytes, *options);
  if (!answer) return reply_problem(response, answer.status());
  reply_json(response, 200, encode(*answer), answer->revision);
}

void load_guides(Service& service, Scene& scene, const Request& request, Response& response, const Upload& file) {
  const auto how = decode_guide_query(query_of(request));
  if (!how) return reply_problem(response, how.status());
  auto options = change_options_of(request);
  if (!options) return reply_problem(response, options.status());
  options->cancel = file.cancel;
  const auto answer = service.scenes.load_guides(scene, *how, file.bytes, *options);
  if (!answer) return reply_problem(response, answer.status());
  reply_json(response, 200, encode(*answer), answer->revision);
}

void store_picture(Service& service, Scene&, const Request& request, Response& response, const Upload& file) {
  if (Status status = check_query(request, {}); !status.ok()) return reply_problem(response, status);
  const auto answer = service.scenes.store_picture(file.bytes, file.cancel);
  if (!answer) return reply_problem(response, answer.status());
  reply_json(response, 200, encode(*answer));
}

/// One kind of upload.
struct Kind {
  std::size_t max_bytes;
  void (*use)(Service& service, Scene& scene, const Request& request, Response& response, const Upload& file);
};

/// Reads the whole body. A failure leaves bytes unread, so the caller has to end the connection.
Result<std::string> read_body(const Request& request, const httplib::ContentReader& read, std::size_t max_bytes) {
  const auto length = request.get_header_value<std::uint64_t>("Content-Length");
  if (length > max_bytes) {
    return failure(Code::too_large, fmt::format("The upload has {} bytes.", length), "",
                   fmt::format("at most {} bytes", max_bytes));
  }
  std::string bytes;
  const bool complete = read([&](const char* data, std::size_t size) {
    bytes.append(data, size);
    return bytes.size() <= max_bytes;
  });
  if (!complete) return failure(Code::malformed, "The body ended before its Content-Length.");
  return bytes;
}

/// Reads the body and passes it to `use`; refuses (unavailable) while too many other uploads are being read.
void with_body(Service& service, std::size_t max_bytes, const Request& request, Response& response,
               const httplib::ContentReader& read, const std::function<void(const std::string& bytes)>& use) {
  const auto pass = service.uploads.enter(client_of(request));
  if (!pass) {
    const std::string limit =
        fmt::format("{} at a time, {} of one client", service.uploads.capacity(), service.uploads.per_client());
    reply_problem(response, failure(Code::unavailable, "Other uploads are being read.", "", limit));
    return close_after(response);
  }
  const Result<std::string> bytes = read_body(request, read, max_bytes);
  if (!bytes) {
    reply_problem(response, bytes.status());
    return close_after(response);
  }
  use(*bytes);
}

void upload(Service& service, const Kind& kind, const Request& request, Response& response,
            const httplib::ContentReader& read) {
  with_body(service, kind.max_bytes, request, response, read, [&](const std::string& bytes) {
    with_scene(service, request, response, [&](const auto& scene) {
      const ClientSocket client(request);
      const Upload file{std::as_bytes(std::span(bytes)), cancel_of(client)};
      kind.use(service, *scene, request, response, file);
    });
  });
}

/// Returns the name for a new scene, checked like that of a branch; empty without the parameter.
Result<std::string> name_of(const Request& request) {
  if (Status status = check_query(request, {"name"}); !status.ok()) return status;
  if (!request.has_param("name")) return std::string();
  const auto named = decode_branch(encode(BranchRequest{.name = request.get_param_value("name")}));
  return named ? named->name : Result<std::string>(named.status());
}

void open_scene(Service& service, const Request& request, Response& response, const httplib::ContentReader& read) {
  const Result<std::string> name = name_of(request);
  with_body(service, limits::model_bytes, request, response, read, [&](const std::string& bytes) {
    if (!name) return reply_problem(response, name.status());
    const ClientSocket client(request);
    reply_created(response, open_saved(service.scenes, bytes, *name, cancel_of(client)));
  });
}

void put(httplib::Server& server, Service& service, const char* name, Kind kind) {
  const std::string pattern = std::string("/v1/scenes/([^/]+)/") + name;
  server.Put(pattern, [&service, kind](const Request& request, Response& response, const httplib::ContentReader& read) {
    upload(service, kind, request, response, read);
  });
}

}  // namespace

void add_upload_routes(httplib::Server& server, Service& service) {
  server.Post("/v1/open", [&service](const Request& request, Response& response, const httplib::ContentReader& read) {
    open_scene(service, request, response, read);
  });
  put(server, service, "model", {limits::model_bytes, load_model});
  put(server, service, "environment", {limits::picture_bytes, load_environment});
  put(server, service, "skin_texture", {limits::picture_bytes, load_skin_texture});
  put(server, service, "maps/([^/]+)", {limits::picture_bytes, load_map});
  put(server, service, "guides", {limits::guide_bytes, load_guides});
  put(server, service, "pictures", {limits::picture_bytes, store_picture});
}

}  // namespace pelage
