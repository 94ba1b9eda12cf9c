// Runs a request with an Idempotency-Key once, even if the client sends it again.
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

/// Returns the path, key and fingerprint of a request with an Idempotency-Key; none without the header.
std::optional<KeyedRequest> keyed_request_of(const httplib::Request& request);

/// Returns the refusal (invalid) of a key that came with another request before.
Status key_reuse_refusal();

/// Caches the answers of the newest requests that succeeded and had an Idempotency-Key. Thread-safe.
class IdempotencyCache {
 public:
  /// Runs `run` and caches its answer, or repeats the cached answer. Without the header it only runs. Refuses with 409
  /// while the first request is running, and with 422 if the key came with another body or address.
  void answer(const httplib::Request& request, httplib::Response& response, const std::function<void()>& run);

 private:
  struct Entry {
    std::string fingerprint;
    bool running = true;
    int status = 0;
    std::string body;
    std::string location, etag;
  };

  /// Enters a new request as running and returns true; answers or refuses a known one and returns false.
  bool begin(const std::string& key, const Entry& entry, httplib::Response& response);
  void finish(const std::string& key, const httplib::Response& response);

  std::mutex mutex_;
  std::map<std::string, Entry> entries_;
  std::deque<std::string> finished_;  // oldest first
};

}  // namespace pelage
