// cpp-httplib's server behind a reception of our own.
#pragma once

#include <httplib.h>

#include <functional>
#include <memory>
#include <string>

#include "server/http/transport/connection.h"
#include "server/http/transport/reception.h"

namespace pelage {

/// Routes, parses and answers as cpp-httplib does, which by itself gives each connection a thread for as long as it
/// lives: 128 idle clients lock all others out.
class HttpTransport : public httplib::Server {
 public:
  struct Hooks {
    /// Before the handlers of a request, whose head is parsed.
    std::function<void(const httplib::Request&, Exchange&)> begun;
    /// The whole answer to a request that reaches no handler: 408, 431 or 503.
    std::function<std::string(Exchange&, int http_status)> refusal;
    /// After each answer, on any thread.
    std::function<void(const Exchange&)> ended;
    /// Returns whether a GET or HEAD of a path, without its query, may take the reserved worker.
    std::function<bool(const std::string& path)> is_probe;
  };

  /// Serves a socket that is bound until stop_serving() and what runs then has ended; false when it failed.
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
  Reception* reception_ = nullptr;  // while it runs
};

/// The exchange that a request of a handler belongs to; null for a request whose head was malformed.
Exchange* exchange_of(const httplib::Request& request);

}  // namespace pelage
