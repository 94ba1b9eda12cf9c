// One thread that holds the connections of all clients and passes complete requests to workers.
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
  std::size_t waiting_requests = 256;    // limit of the requests that wait for a worker
  std::size_t connections = 512;         // limit; beyond it the longest idle connection is closed
  std::size_t head_bytes = 32 * 1024;    // limit of a request's first line and headers
  Milliseconds head_timeout{10'000};     // from the first byte of a head to its last
  Milliseconds idle_timeout{60'000};     // of a connection without a request
  Milliseconds linger_timeout{1'000};    // for a client to read the last answer
  Milliseconds stopping_timeout{8'000};  // for requests that run when the server stops; then they are disconnected
};

/// Idle and slow clients take memory here but no thread: a connection gets a worker once the head of a request is
/// complete, and returns here after the answer. One more worker is reserved for urgent requests.
class Reception {
 public:
  struct Calls {
    /// Answers one request, whose head is complete, on a worker's thread. False ends the connection. Must not throw.
    std::function<bool(Connection&, std::chrono::steady_clock::time_point head_complete)> serve;
    /// Returns the bytes of the answer to a request that reaches no worker: 408 (its head was too slow), 431 (its head
    /// is too large) or 503 (too many requests wait).
    std::function<std::string(const Connection&, int http_status)> refusal;
    std::function<bool(const RequestLine&)> urgent;
  };

  /// Accepts connections of a listening socket, which the caller owns. Throws std::system_error if the system is out of
  /// threads or file descriptors.
  Reception(int listening, const ReceptionLimits& limits, Calls calls);
  ~Reception();

  /// Serves on this thread until stop() is called and running requests have ended. Returns false if the listening
  /// socket failed.
  bool run();
  /// Thread-safe; may come before run().
  void stop();

 private:
  enum class State { waiting, served, closing };
  using Clock = std::chrono::steady_clock;
  struct Entry {
    std::unique_ptr<Connection> connection;  // while served, only the worker may use it, except its socket
    State state = State::waiting;
    Clock::time_point since;   // start of the state; for a head, arrival of its first byte
    std::size_t searched = 0;  // unread bytes known not to hold the end of a head
  };
  using Entries = std::map<int, Entry>;  // by socket

  void handle_events(int wait_milliseconds);
  void accept_all();
  bool accept_one();
  bool close_longest_idle();
  void run_or_drop(int socket, void (Reception::*action)(Entries::iterator));
  void receive(Entries::iterator entry);
  void dispatch_if_complete(Entries::iterator entry);
  void refuse(Entries::iterator entry, int http_status);
  void begin_closing(Entries::iterator entry);
  void drop(Entries::iterator entry);
  void watch(int socket);
  void unwatch(int socket);
  void give_back(int socket, bool keep_alive);
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
  std::vector<std::pair<int, bool>> returned_;  // sockets back from workers; true if the connection stays
  std::unique_ptr<Workers> workers_;            // declared last: ends before what its tasks use
};

}  // namespace pelage
