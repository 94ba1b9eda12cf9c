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
  int port = 0;                    // 0 for a free one
  std::string token;               // when given, every call needs it but /livez, /readyz, the studio's files and /docs
  std::vector<std::string> hosts;  // names that a request may address beside the loopback ones, without ports
};

/// What is served; all of it outlives the server.
struct ServedParts {
  SceneStore& scenes;
  FrameService& frames;
  TraceQueue& traces;
  YieldGate& gate;  // commands go first
  const ServerLog& log;
};

class HttpServer {
 public:
  /// Binds. Refused (invalid) when the address is not a loopback one and there is no token, or cannot be bound.
  static Result<std::unique_ptr<HttpServer>> listen(const HttpOptions& options, const ServedParts& parts);
  ~HttpServer();

  int port() const;
  /// Serves on this thread until stop() is called and what runs is finished. Fails (internal) when the listening
  /// socket gives up before that.
  Status run();
  /// Stops the server: it is no longer ready, ends waits and traces, and takes no new connections. Thread-safe.
  void stop();

 private:
  struct Impl;
  explicit HttpServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
