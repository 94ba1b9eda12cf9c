// cpp-httplib's server with connections that are managed by Reception.
#pragma once

#include <httplib.h>

#include <functional>
#include <memory>
#include <string>

#include "server/http/transport/connection.h"
#include "server/http/transport/reception.h"

namespace pelage {

/// Parses, routes and answers requests by cpp-httplib, but gives threads to requests only. cpp-httplib itself gives
/// each connection a thread for as long as it lives: 128 idle clients would lock all others out.
class HttpTransport : public httplib::Server {
 public:
  struct Hooks {
    /// Called after the head of a request is parsed, before its handlers.
    std::function<void(const httplib::Request&, Exchange&)> begun;
    /// Returns the whole answer to a request that reaches no handler: 408, 431 or 503.
    std::function<std::string(Exchange&, int http_status)> refusal;
    /// Called after each answer, on any thread.
    std::function<void(const Exchange&)> ended;
    /// Returns whether a GET or HEAD of a path, without its query, may take the reserved worker.
    std::function<bool(const std::string& path)> is_probe;
  };

  /// Serves the bound socket until stop_serving() is called and running requests have ended. Returns false if the
  /// socket failed.
  bool serve(const ReceptionLimits& limits, Hooks hooks);
  /// Thread-safe; may come before serve().
  void stop_serving();

 private:
  /// Serves one request on a worker's thread. An exception ends this connection alone. Returns false when the
  /// connection ends.
  bool serve_one(Connection& connection, std::chrono::steady_clock::time_point begin);
  bool answer_one(Connection& connection, Exchange& exchange);

  Hooks hooks_;
  std::mutex mutex_;
  bool stopped_ = false;
  Reception* reception_ = nullptr;  // null unless serve() is running
};

/// The exchange that a request of a handler belongs to; null for a request whose head was malformed.
Exchange* exchange_of(const httplib::Request& request);

}  // namespace pelage
