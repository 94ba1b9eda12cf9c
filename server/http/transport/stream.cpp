#include "server/http/transport/stream.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <charconv>

namespace pelage {

namespace {

using std::chrono::milliseconds;
constexpr milliseconds still_time{5'000}, slow_time{30'000};
constexpr std::size_t min_bytes_per_millisecond = 8;

}  // namespace

bool ConnectionStream::wait(short event) const {
  const auto begin = std::chrono::steady_clock::now();
  const auto left = slow_time + milliseconds(transferred_ / min_bytes_per_millisecond) - waited_;
  const auto time = std::clamp(std::chrono::ceil<milliseconds>(left), milliseconds(0), still_time);
  pollfd descriptor{connection_.socket(), event, 0};
  int ready = 0;
  do {
    ready = poll(&descriptor, 1, static_cast<int>(time.count()));
  } while (ready < 0 && errno == EINTR);
  waited_ += std::chrono::steady_clock::now() - begin;
  return ready > 0;
}

bool ConnectionStream::is_readable() const { return !connection_.unread().empty() || wait(POLLIN); }

bool ConnectionStream::is_writable() const { return !broken_ && wait(POLLOUT); }

ssize_t ConnectionStream::read(char* to, std::size_t size) {
  if (const std::size_t taken = connection_.take(to, size); taken > 0) return static_cast<ssize_t>(taken);
  if (!wait(POLLIN)) return -1;
  const ssize_t received = recv(connection_.socket(), to, size, 0);
  if (received > 0) transferred_ += static_cast<std::size_t>(received);
  return received;
}

ssize_t ConnectionStream::write(const char* from, std::size_t size) {
  note_status({from, size});
  for (std::size_t written = 0; written < size && !broken_;) {
    const ssize_t sent = send(connection_.socket(), from + written, size - written, MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent > 0) {
      written += static_cast<std::size_t>(sent);
      transferred_ += static_cast<std::size_t>(sent);
      exchange_.bytes += static_cast<std::size_t>(sent);
    } else {
      const bool full = sent < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
      broken_ = !full || !wait(POLLOUT);
    }
  }
  return broken_ ? -1 : static_cast<ssize_t>(size);
}

/// Reads the status from the answer's bytes: cpp-httplib does not report its answer to a malformed request.
void ConnectionStream::note_status(std::string_view bytes) {
  static constexpr std::string_view version = "HTTP/1.1 ";
  constexpr int first_final = 200;
  if (exchange_.status >= first_final || !bytes.starts_with(version)) return;
  std::from_chars(bytes.data() + version.size(), bytes.data() + bytes.size(), exchange_.status);
}

void ConnectionStream::get_remote_ip_and_port(std::string& address, int& port) const {
  address = connection_.address();
  port = connection_.port();
}

/// Returns no address: the server does not use its own.
void ConnectionStream::get_local_ip_and_port(std::string& address, int& port) const {
  address.clear();
  port = -1;
}

}  // namespace pelage
