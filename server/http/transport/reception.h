// One thread holds the connections of all clients.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "server/http/transport/connection.h"
#include "server/http/transport/workers.h"

namespace pelage {

struct ReceptionLimits {
  using Milliseconds = std::chrono::milliseconds;
  int workers = 128;
  std::size_t waiting_requests = 256;    // that wait for a worker
  std::size_t connections = 512;         // beyond it the one that is idle longest is closed
  std::size_t head_bytes = 32 * 1024;    // of a request's first line and headers
  Milliseconds head_timeout{10'000};     // from the first byte of a head to its last
  Milliseconds idle_timeout{60'000};     // without a request
  Milliseconds linger_timeout{1'000};    // for a client to read the last answer
  Milliseconds stopping_timeout{8'000};  // for requests that run when the server stops; then their clients are cut off
};

/// Idle and slow clients take memory here and no thread: a connection takes a worker once the head of a request is
/// complete, and comes back after the answer. One more worker is reserved for urgent requests.
class Reception {
 public:
  struct Calls {
    /// Answers one request, whose head is whole, on a worker's thread. False: the connection ends. Throws nothing.
    std::function<bool(Connection&, std::chrono::steady_clock::time_point head_was_whole)> serve;
    /// The bytes of an answer for a request that reaches no worker: 408 (its head was too slow), 431 (too large) or 503
    /// (too many wait).
    std::function<std::string(const Connection&, int http_status)> refusal;
    std::function<bool(const RequestLine&)> urgent;
  };

  /// Takes connections of a socket that listens, which stays the caller's. Throws std::system_error when the machine
  /// has no room for a thread or a file.
  Reception(int listening, const ReceptionLimits& limits, Calls calls);
  ~Reception();

  /// Serves on this thread until stop() is called and what runs then has ended. Returns false when the listening socket
  /// failed.
  bool run();
  /// Thread-safe; may come before run().
  void stop();

 private:
  enum class State { waiting, served, closing };
  using Clock = std::chrono::steady_clock;
  struct Entry {
    std::unique_ptr<Connection> connection;  // while it is served the worker's alone, but for its socket
    State state = State::waiting;
    Clock::time_point since;   // of the state; of a head, when its first byte came
    std::size_t searched = 0;  // unread bytes that hold no end of a head
  };
  using Entries = std::map<int, Entry>;  // by socket

  void handle_events(int wait_milliseconds);
  void accept_all();
  bool accept_one();
  bool make_room();
  void or_drop(int socket, void (Reception::*action)(Entries::iterator));
  void receive(Entries::iterator entry);
  void begin_if_whole(Entries::iterator entry);
  void refuse(Entries::iterator entry, int http_status);
  void begin_closing(Entries::iterator entry);
  void drop(Entries::iterator entry);
  void watch(int socket);
  void unwatch(int socket);
  void give_back(int socket, bool stays);
  void take_back();
  void check_timeouts();
  void check_timeout(Entries::iterator entry);
  void begin_stopping();

  const int listening_;
  const ReceptionLimits limits_;
  const Calls calls_;
  int epoll_ = -1, wake_ = -1;
  Entries entries_;
  Clock::time_point now_;
  Clock::time_point stopping_since_;
  bool stopping_ = false, failed_ = false;
  std::atomic<bool> stop_asked_{false};
  std::mutex mutex_;
  std::vector<std::pair<int, bool>> returned_;  // sockets from workers, and whether they stay
  std::unique_ptr<Workers> workers_;            // ends before all that its tasks use
};

}  // namespace pelage
