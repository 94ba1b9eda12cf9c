// Requests that a client may send twice and that are run once.
#pragma once

#include <httplib.h>

#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "base/status.h"
#include "server/history/history.h"

namespace pelage {

inline constexpr const char* idempotency_header = "Idempotency-Key";

/// Returns the request with its Idempotency-Key; none without one.
std::optional<KeyedRequest> keyed_request_of(const httplib::Request& request);

/// The refusal (invalid) of a key that came with another request.
Status other_request();

/// Thread-safe. Keeps the answers of the newest requests that succeeded and had an Idempotency-Key.
class IdempotencyCache {
 public:
  /// Runs `run` and keeps its answer, or answers from memory. Without the header it just runs. Refuses: 409 while the
  /// first request is running, 422 when the key came with another body or address.
  void answer(const httplib::Request& request, httplib::Response& response, const std::function<void()>& run);

 private:
  struct Entry {
    std::string fingerprint;
    bool running = true;
    int status = 0;
    std::string body;
    std::string location, etag;
  };

  /// Answers from memory, or enters the request as running and returns true.
  bool begin(const std::string& key, const Entry& entry, httplib::Response& response);
  void finish(const std::string& key, const httplib::Response& response);

  std::mutex mutex_;
  std::map<std::string, Entry> entries_;
  std::deque<std::string> finished_;  // oldest first
};

}  // namespace pelage
