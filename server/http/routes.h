// Registers the handlers of all addresses, and holds what they share. Each group of routes has a file of its own.
#pragma once

#include <httplib.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include "base/limits.h"
#include "protocol/json/decode.h"
#include "server/frames/frame_service.h"
#include "server/frames/picture_service.h"
#include "server/http/client_gate.h"
#include "server/http/guard.h"
#include "server/http/http_server.h"
#include "server/http/idempotency.h"
#include "server/http/mesh_cache.h"
#include "server/http/status_routes.h"
#include "server/scene/scene_store.h"

namespace pelage {

inline constexpr int worker_threads = 128;

/// The state that all handlers share. Everything in it is thread-safe.
struct Service {
  SceneStore& scenes;
  FrameService& frames;
  TraceQueue& traces;
  YieldGate& gate;
  PictureService pictures{frames, traces};
  Metrics metrics;
  IdempotencyCache idempotency;
  MeshCache meshes;
  Gate waiting{worker_threads / 4};  // each waiting request holds a thread for seconds
  Gate streams{worker_threads / 4};  // each event stream holds a thread as long as its client stays
  ClientGate uploads{4, 2};          // each upload holds a file in memory and a process that reads it
  Gate large_frames{1};
  Gate exports{1};  // each export holds all strands of a scene in memory
  std::atomic<bool> draining{false};

  explicit Service(const ServedParts& parts)
      : scenes(parts.scenes), frames(parts.frames), traces(parts.traces), gate(parts.gate) {}
  /// Returns ok if the server takes work, else the reason why not.
  Status readiness() const;
};

void add_scene_routes(httplib::Server& server, Service& service);
void add_upload_routes(httplib::Server& server, Service& service);
void add_command_routes(httplib::Server& server, Service& service);
void add_frame_routes(httplib::Server& server, Service& service);
/// Picks, and recipes, which are made with picks.
void add_pick_routes(httplib::Server& server, Service& service);
void add_map_routes(httplib::Server& server, Service& service);
void add_mesh_routes(httplib::Server& server, Service& service);
void add_export_routes(httplib::Server& server, Service& service);
void add_event_routes(httplib::Server& server, Service& service);
void add_status_routes(httplib::Server& server, Service& service);
void add_embedded_file_routes(httplib::Server& server);

/// Answers with a new scene and its Location (201), or with the problem.
void reply_created(httplib::Response& response, const Result<std::shared_ptr<Scene>>& scene);

/// Finds the scene of the address ("/v1/scenes/{id}...") and calls `use`, or answers 404.
void with_scene(Service& service, const httplib::Request& request, httplib::Response& response,
                const std::function<void(const std::shared_ptr<Scene>&)>& use);

/// Returns a Cancel that stops the work once the client has hung up, or was disconnected by a stopping server.
/// Valid as long as `client` lives.
Cancel cancel_of(const ClientSocket& client);

/// Returns the id by which the renderer caches the scene's model.
std::uint64_t model_id_of(const Scene& scene);

/// Runs a request once. If a request with its Idempotency-Key has made a change already, even before a restart, `again`
/// answers from that change instead.
void run_once(Service& service, const httplib::Request& request, httplib::Response& response,
              const std::function<void(const RequestedChange&)>& again, const std::function<void()>& run);

/// Adds a POST handler; bodies of more than `max_bytes` are refused (413).
void add_post(httplib::Server& server, const std::string& pattern, const httplib::Server::Handler& handler,
              std::size_t max_bytes = limits::command_body_bytes);

Query query_of(const httplib::Request& request);
/// Returns the query with the field of the address ".../maps/{field}" as one more parameter.
Query map_query_of(const httplib::Request& request);
/// Refuses (invalid) parameters of the address that are not among `known`, and repeated ones (malformed).
Status check_query(const httplib::Request& request, const std::vector<std::string_view>& known);

/// Reads If-Match, Pelage-Author and Idempotency-Key of a request that changes a scene. Fails (malformed) as
/// if_match_of and check_author do, and if there is more than one author.
Result<ExecuteOptions> change_options_of(const httplib::Request& request);

/// The template of a path, such as "/v1/scenes/{id}/undo", and the methods that it takes; "other" and no methods for a
/// path without a handler.
struct RouteInfo {
  std::string path;
  std::string methods;
};
RouteInfo route_of(const std::string& path);

}  // namespace pelage
