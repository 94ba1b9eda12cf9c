#include "clients/cli/actions/upload.h"

#include <fmt/format.h>

#include <atomic>

#include "clients/cli/terminal/progress.h"

namespace pelage {

namespace {

/// Shows upload progress while `send` runs. `send` gets a callback, to be called with the number of bytes sent so far.
template <class Send>
Result<HttpAnswer> with_progress(std::size_t size, Send send) {
  std::atomic<std::size_t> sent = 0;
  const ProgressLine line("uploading", [&sent, size]() -> ProgressState {
    const std::size_t now = sent;
    if (now >= size) return {-1, "sent; the server is processing it"};
    return {static_cast<double>(now) / static_cast<double>(size),
            fmt::format("{:.1f} MB", static_cast<double>(size) / 1e6)};
  });
  return Session::accepted(send([&sent](std::size_t bytes) { sent = bytes; }));
}

}  // namespace

Result<HttpAnswer> put_with_progress(Session& session, const std::string& address, const std::string& bytes) {
  return with_progress(bytes.size(),
                       [&](const SentCallback& sent) { return session.connection().put_bytes(address, bytes, sent); });
}

Result<HttpAnswer> post_with_progress(Session& session, const std::string& address, const std::string& bytes) {
  return with_progress(bytes.size(),
                       [&](const SentCallback& sent) { return session.connection().post_bytes(address, bytes, sent); });
}

}  // namespace pelage
