#include "server/http/idempotency.h"

#include "base/limits.h"
#include "server/http/reply.h"
#include "server/scene/digest.h"

namespace pelage {

namespace {

constexpr std::size_t max_cached_answers = 1000;
constexpr std::size_t max_cached_body_bytes =
    64 * 1024;  // longer answers (large batches) are run once and not repeated

}  // namespace

std::optional<KeyedRequest> keyed_request_of(const httplib::Request& request) {
  std::string key = request.get_header_value(idempotency_header);
  if (key.empty()) return {};
  return KeyedRequest{request.path, std::move(key),
                      digest(request.method + "\n" + request.target + "\n" + request.body)};
}

Status key_reuse_refusal() { return failure(Code::invalid, "This Idempotency-Key came with another request before."); }

void IdempotencyCache::answer(const httplib::Request& request, httplib::Response& response,
                              const std::function<void()>& run) {
  const std::optional<KeyedRequest> keyed = keyed_request_of(request);
  if (!keyed) return run();
  if (keyed->key.size() > limits::name_bytes) {
    return reply_problem(response,
                         failure(Code::malformed, "The Idempotency-Key is too long.", "", "at most 200 bytes"));
  }
  const std::string name = keyed->path + "\n" + keyed->key;
  Entry entry;
  entry.fingerprint = keyed->fingerprint;
  if (!begin(name, entry, response)) return;
  // Runs on every exit, a thrown exception included, so that no key stays "running".
  const std::shared_ptr<void> finisher(nullptr, [&](void*) { finish(name, response); });
  run();
}

bool IdempotencyCache::begin(const std::string& key, const Entry& entry, httplib::Response& response) {
  const std::lock_guard lock(mutex_);
  const auto [found, fresh] = entries_.try_emplace(key, entry);
  if (fresh) return true;
  const Entry& known = found->second;
  if (known.fingerprint != entry.fingerprint) {
    reply_problem(response, key_reuse_refusal());
  } else if (known.running) {
    reply_problem(response, failure(Code::conflict, "The first request with this Idempotency-Key is still running."));
  } else {
    reply_json(response, known.status, known.body);
    if (!known.location.empty()) response.set_header("Location", known.location);
    if (!known.etag.empty()) response.set_header("ETag", known.etag);
  }
  return false;
}

void IdempotencyCache::finish(const std::string& key, const httplib::Response& response) {
  const std::lock_guard lock(mutex_);
  const bool keep = response.status >= 200 && response.status < 300 && response.body.size() <= max_cached_body_bytes;
  if (!keep) {
    entries_.erase(key);
    return;
  }
  Entry& entry = entries_[key];
  entry.running = false;
  entry.status = response.status;
  entry.body = response.body;
  entry.location = response.get_header_value("Location");
  entry.etag = response.get_header_value("ETag");
  finished_.push_back(key);
  if (finished_.size() > max_cached_answers) {
    entries_.erase(finished_.front());
    finished_.pop_front();
  }
}

}  // namespace pelage
