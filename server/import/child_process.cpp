#include "server/import/child_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

namespace pelage {

namespace {

using Clock = std::chrono::steady_clock;

/// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int get() const { return number_; }
  bool is_open() const { return number_ >= 0; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

struct Channel {
  Descriptor ours, theirs;
};

/// Opens sockets, not pipes, because a write to a socket whose other end is closed need not raise SIGPIPE.
bool open_channel(Channel& channel) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return false;
  channel.ours = Descriptor(ends[0]);
  channel.theirs = Descriptor(ends[1]);
  return true;
}

class SpawnActions {
 public:
  SpawnActions(int stream, int error) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, stream, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, stream, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, error, STDERR_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
    posix_spawnattr_init(&attributes_);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~SpawnActions() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;

  int spawn(pid_t& child, const std::vector<std::string>& arguments) const {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    char* environment[] = {nullptr};
    return posix_spawn(&child, argv[0], &actions_, &attributes_, argv.data(), environment);
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

constexpr long long max_wait = 250;  // milliseconds between calls of limits.cancelled

int milliseconds_until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, max_wait));
}

/// The exchange of data with a running child, over its stream (in and out) and its standard error.
class Conversation {
 public:
  Conversation(Descriptor stream, Descriptor error, std::span<const std::byte> input, const ChildLimits& limits,
               const TakeAnswer& take)
      : stream_(std::move(stream)),
        error_(std::move(error)),
        input_(input),
        take_(take),
        cancelled_(limits.cancelled),
        answer_bytes_(limits.answer_bytes),
        deadline_(Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                     std::chrono::duration<double>(std::clamp(limits.seconds, 0.0, 1e6)))) {}

  /// Exchanges data until the child has closed both streams, or breaks a limit.
  void hold(ChildResult& result) {
    while (stream_.is_open() || error_.is_open()) {
      std::array<pollfd, 2> waits = {pollfd{stream_.get(), POLLIN, 0}, pollfd{error_.get(), POLLIN, 0}};
      if (!all_sent_) waits[0].events |= POLLOUT;
      const int ready = poll(waits.data(), waits.size(), milliseconds_until(deadline_));
      if (ready < 0 && errno == EINTR) continue;
      result.cancelled = cancelled_ && cancelled_();
      if (result.cancelled) return;
      if (ready == 0 && Clock::now() < deadline_) continue;
      if (ready <= 0) {
        result.timed_out = true;
        return;
      }
      if (waits[0].revents & POLLOUT) send_some();
      if (waits[0].revents & (POLLIN | POLLHUP | POLLERR)) {
        const std::string_view answer = receive(stream_);
        result.too_long = answer.size() > answer_bytes_;
        if (result.too_long || (!answer.empty() && !take_(answer))) return;
        answer_bytes_ -= answer.size();
      }
      if (waits[1].revents & (POLLIN | POLLHUP | POLLERR)) {
        const std::string_view complaint = receive(error_);
        result.complaint += complaint.substr(0, max_complaint - result.complaint.size());
      }
    }
  }

 private:
  static constexpr std::size_t max_complaint = 4096;

  void send_some() {
    if (!input_.empty()) {
      const ssize_t sent = send(stream_.get(), input_.data(), input_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent > 0) input_ = input_.subspan(static_cast<std::size_t>(sent));
      if (sent < 0 && errno != EAGAIN && errno != EINTR) input_ = {};  // the child does not read; its answer says why
    }
    if (!input_.empty()) return;
    all_sent_ = true;
    shutdown(stream_.get(), SHUT_WR);
  }

  /// Returns the bytes that are available, valid until the next call. Closes `from` at its end.
  std::string_view receive(Descriptor& from) {
    const ssize_t count = recv(from.get(), buffer_.data(), buffer_.size(), MSG_DONTWAIT);
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return {};
    if (count <= 0) from.close();
    return {buffer_.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
  }

  Descriptor stream_, error_;
  std::span<const std::byte> input_;
  const TakeAnswer& take_;
  const std::function<bool()>& cancelled_;
  std::array<char, 65536> buffer_;
  std::size_t answer_bytes_;  // that the child may still send
  Clock::time_point deadline_;
  bool all_sent_ = false;
};

/// Kills the child if it is still running, and reads its exit status. A child that has closed its streams is exiting
/// already and keeps its own status.
void reap(pid_t child, ChildResult& result) {
  kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result.signal = WTERMSIG(status);
}

}  // namespace

Result<ChildResult> run_child(const std::vector<std::string>& arguments, std::span<const std::byte> input,
                              const ChildLimits& limits, const TakeAnswer& take) {
  Channel stream, error;
  if (!open_channel(stream) || !open_channel(error)) {
    return failure(Code::unavailable, std::string("No sockets are left: ") + std::strerror(errno));
  }
  pid_t child = 0;
  const int problem = SpawnActions(stream.theirs.get(), error.theirs.get()).spawn(child, arguments);
  if (problem != 0) {
    return failure(Code::internal, "The program " + arguments[0] + " cannot be started: " + std::strerror(problem));
  }
  stream.theirs.close();
  error.theirs.close();
  ChildResult result;
  {
    Conversation conversation(std::move(stream.ours), std::move(error.ours), input, limits, take);
    conversation.hold(result);
  }
  reap(child, result);
  return result;
}

}  // namespace pelage
