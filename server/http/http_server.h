// The HTTP service: routes, limits, and workarounds for weak spots of cpp-httplib.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "server/frames/frame_service.h"
#include "server/frames/trace_queue.h"
#include "server/frames/yield_gate.h"
#include "server/log/server_log.h"
#include "server/scene/scene_store.h"

namespace pelage {

struct HttpOptions {
  std::string host = "127.0.0.1";  // address or name to listen on
  int port = 0;                    // 0 for any free port
  std::string token;               // if given, every call needs it except /livez, /readyz, the studio's files and /docs
  std::vector<std::string> hosts;  // names accepted in the header Host besides the loopback ones, without ports
};

/// The services behind the routes; they outlive the server.
struct ServedParts {
  SceneStore& scenes;
  FrameService& frames;
  TraceQueue& traces;
  YieldGate& gate;  // gives commands priority over background work
  const ServerLog& log;
};

class HttpServer {
 public:
  /// Binds the address. Fails (invalid) if it is not a loopback address and there is no token, or if binding fails.
  static Result<std::unique_ptr<HttpServer>> listen(const HttpOptions& options, const ServedParts& parts);
  ~HttpServer();

  int port() const;
  /// Serves on this thread until stop() is called and running requests have finished. Fails (internal) if the listening
  /// socket fails before that.
  Status run();
  /// Stops the server: it reports that it is not ready, ends waits and traces, and takes no new connections.
  /// Thread-safe.
  void stop();

 private:
  struct Impl;
  explicit HttpServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
