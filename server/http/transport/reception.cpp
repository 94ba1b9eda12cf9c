#include "server/http/transport/reception.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <new>
#include <system_error>

namespace pelage {

namespace {

constexpr int check_milliseconds = 100;         // how often timeouts are checked
constexpr std::size_t block_bytes = 16 * 1024;  // received by one call of recv()
constexpr int no_socket_microseconds = 10'000;  // pause when the system has no free socket

int or_throw(int descriptor) {
  if (descriptor < 0) throw std::system_error(errno, std::generic_category());
  return descriptor;
}

std::unique_ptr<Connection> connection_of(int socket, const sockaddr_storage& peer) {
  std::array<char, INET6_ADDRSTRLEN> text{};
  int port = -1;
  if (peer.ss_family == AF_INET) {
    const auto& v4 = reinterpret_cast<const sockaddr_in&>(peer);
    inet_ntop(AF_INET, &v4.sin_addr, text.data(), text.size());
    port = ntohs(v4.sin_port);
  } else if (peer.ss_family == AF_INET6) {
    const auto& v6 = reinterpret_cast<const sockaddr_in6&>(peer);
    inet_ntop(AF_INET6, &v6.sin6_addr, text.data(), text.size());
    port = ntohs(v6.sin6_port);
  }
  return std::make_unique<Connection>(socket, text.data(), port);
}

bool client_left_early(int error) {
  return error == ECONNABORTED || error == EPROTO || error == EINTR || error == EPERM;
}

bool machine_is_full(int error) { return error == EMFILE || error == ENFILE || error == ENOBUFS || error == ENOMEM; }

}  // namespace

Reception::Reception(int listening, const ReceptionLimits& limits, Calls calls)
    : listening_(listening),
      limits_(limits),
      calls_(std::move(calls)),
      epoll_(or_throw(epoll_create1(EPOLL_CLOEXEC))),
      wake_(or_throw(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK))),
      workers_(std::make_unique<Workers>(limits.workers, limits.waiting_requests)) {
  fcntl(listening_, F_SETFL, fcntl(listening_, F_GETFL) | O_NONBLOCK);
  watch(listening_);
  watch(wake_);
}

Reception::~Reception() {
  workers_.reset();
  close(wake_);
  close(epoll_);
}

bool Reception::run() {
  while (!stopping_ || !entries_.empty()) {
    handle_events(entries_.empty() ? -1 : check_milliseconds);
    take_back();
    if ((stop_asked_ || failed_) && !stopping_) begin_stopping();
    check_timeouts();
  }
  return !failed_;
}

void Reception::stop() {
  stop_asked_ = true;
  eventfd_write(wake_, 1);
}

void Reception::handle_events(int wait_milliseconds) {
  std::array<epoll_event, 64> events{};
  const int count = epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), wait_milliseconds);
  now_ = Clock::now();
  for (int k = 0; k < count; ++k) {  // -1 events after a signal
    const int socket = events[static_cast<std::size_t>(k)].data.fd;
    if (eventfd_t times = 0; socket == wake_) eventfd_read(wake_, &times);
    if (socket == listening_) accept_all();
    if (entries_.contains(socket)) run_or_drop(socket, &Reception::receive);
  }
}

/// Runs an action on a connection. If it runs out of memory, only that connection is closed.
void Reception::run_or_drop(int socket, void (Reception::*action)(Entries::iterator)) {
  try {
    (this->*action)(entries_.find(socket));
  } catch (const std::bad_alloc&) {
    if (const auto entry = entries_.find(socket); entry != entries_.end()) drop(entry);
  }
}

void Reception::accept_all() {
  while (!stopping_ && !failed_ && accept_one()) {
  }
}

/// Accepts one client. Returns false if none is waiting, the system has no free socket or the listening socket failed.
bool Reception::accept_one() {
  sockaddr_storage peer{};
  socklen_t size = sizeof peer;
  const int socket = accept4(listening_, reinterpret_cast<sockaddr*>(&peer), &size, SOCK_CLOEXEC);
  if (socket < 0) {
    if (client_left_early(errno)) return true;
    if (machine_is_full(errno)) {
      if (!close_longest_idle()) usleep(no_socket_microseconds);
      return false;  // epoll reports a waiting client again
    }
    failed_ = errno != EAGAIN && errno != EWOULDBLOCK;
    return false;
  }
  std::unique_ptr<Connection> connection;
  try {
    connection = connection_of(socket, peer);
    if (entries_.size() >= limits_.connections && !close_longest_idle()) return true;
    entries_[socket] = {std::move(connection), State::waiting, now_};
    watch(socket);
  } catch (const std::bad_alloc&) {  // the client is not served
    if (!connection) close(socket);
  }
  return true;
}

/// Closes the connection that has been idle longest, preferably one that has sent no part of a request. Returns false
/// if all are being served.
bool Reception::close_longest_idle() {
  const auto rank = [](const Entry& entry) {
    return std::make_pair(entry.state == State::waiting && !entry.connection->unread().empty(), entry.since);
  };
  auto found = entries_.end();
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
    if (entry->second.state == State::served) continue;
    if (found == entries_.end() || rank(entry->second) < rank(found->second)) found = entry;
  }
  if (found == entries_.end()) return false;
  drop(found);
  return true;
}

void Reception::receive(Entries::iterator entry) {
  auto& [socket, client] = *entry;
  if (client.state == State::served) return;
  std::array<char, block_bytes> block;
  const ssize_t size = recv(socket, block.data(), block.size(), MSG_DONTWAIT);
  if (size < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR)) return;
  if (size <= 0) return drop(entry);
  if (client.state == State::closing) return;  // the bytes are dropped
  if (client.connection->unread().empty()) client.since = now_;
  client.connection->append(block.data(), static_cast<std::size_t>(size));
  dispatch_if_complete(entry);
}

void Reception::dispatch_if_complete(Entries::iterator entry) {
  auto& [socket, client] = *entry;
  const std::string_view unread = client.connection->unread();
  const auto size = head_size(unread, client.searched);
  client.searched = unread.size();
  if (size.value_or(unread.size()) > limits_.head_bytes) return refuse(entry, 431);
  if (!size) return;
  unwatch(socket);
  client.state = State::served;
  const bool urgent = calls_.urgent(request_line_of(unread));
  const auto serve = [this, &connection = *client.connection, begin = now_] {
    give_back(connection.socket(), calls_.serve(connection, begin));
  };
  if (workers_->enqueue(serve, urgent)) return;
  watch(socket);
  refuse(entry, 503);
}

void Reception::refuse(Entries::iterator entry, int http_status) {
  const std::string answer = calls_.refusal(*entry->second.connection, http_status);
  send(entry->first, answer.data(), answer.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  begin_closing(entry);
}

/// Ends sending, and closes once the client has closed too: closing a socket with unread bytes sends a reset, which can
/// discard the answer before the client has read it.
void Reception::begin_closing(Entries::iterator entry) {
  entry->second.state = State::closing;
  entry->second.since = now_;
  if (shutdown(entry->first, SHUT_WR) != 0) drop(entry);
}

void Reception::drop(Entries::iterator entry) { entries_.erase(entry); }

void Reception::watch(int socket) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = socket;
  epoll_ctl(epoll_, EPOLL_CTL_ADD, socket, &event);
}

void Reception::unwatch(int socket) { epoll_ctl(epoll_, EPOLL_CTL_DEL, socket, nullptr); }

void Reception::give_back(int socket, bool keep_alive) {
  const std::lock_guard lock(mutex_);
  returned_.emplace_back(socket, keep_alive);
  eventfd_write(wake_, 1);
}

void Reception::take_back() {
  std::vector<std::pair<int, bool>> returned;
  {
    const std::lock_guard lock(mutex_);
    returned.swap(returned_);
  }
  for (const auto& [socket, keep_alive] : returned) {
    Entry& client = entries_.at(socket);
    client.state = State::waiting;
    client.since = now_;
    client.searched = 0;
    watch(socket);
    run_or_drop(socket, keep_alive && !stopping_ ? &Reception::dispatch_if_complete : &Reception::begin_closing);
  }
}

void Reception::check_timeouts() {
  const bool out_of_time = stopping_ && now_ - stopping_since_ > limits_.stopping_timeout;
  for (auto next = entries_.begin(); next != entries_.end();) {
    const auto entry = next++;
    if (entry->second.state != State::served)
      run_or_drop(entry->first, &Reception::check_timeout);
    else if (out_of_time)
      shutdown(entry->first, SHUT_RDWR);  // only the worker may use the connection
  }
}

void Reception::check_timeout(Entries::iterator entry) {
  const Entry& client = entry->second;
  const auto passed = now_ - client.since;
  if (client.state == State::closing) {
    if (passed > limits_.linger_timeout) drop(entry);
  } else if (client.connection->unread().empty()) {
    if (passed > limits_.idle_timeout) drop(entry);
  } else if (passed > limits_.head_timeout) {
    refuse(entry, 408);
  }
}

void Reception::begin_stopping() {
  stopping_ = true;
  stopping_since_ = now_;
  unwatch(listening_);
  shutdown(listening_, SHUT_RDWR);  // new clients are refused at once
  for (auto next = entries_.begin(); next != entries_.end();) {
    const auto entry = next++;
    if (entry->second.state == State::waiting) drop(entry);
  }
}

}  // namespace pelage
