// What cpp-httplib reads requests from and writes answers to.
#pragma once

#include <httplib.h>

#include <chrono>
#include <string_view>

#include "server/http/transport/connection.h"

namespace pelage {

/// A connection while one request is served. Waits for a client that stands still 5 s, and for one that is slow 30 s in
/// all, and a second more for each 8 KiB.
class ConnectionStream : public httplib::Stream {
 public:
  ConnectionStream(Connection& connection, Exchange& exchange) : connection_(connection), exchange_(exchange) {}

  bool is_readable() const override;
  bool is_writable() const override;
  /// -1 when nothing came in time, 0 at the end.
  ssize_t read(char* to, std::size_t size) override;
  /// All of it, or -1.
  ssize_t write(const char* from, std::size_t size) override;
  void get_remote_ip_and_port(std::string& address, int& port) const override;
  void get_local_ip_and_port(std::string& address, int& port) const override;
  socket_t socket() const override { return connection_.socket(); }

  /// Returns whether a write has failed, after which nothing can follow.
  bool broken() const { return broken_; }

 private:
  bool wait(short event) const;
  void note_status(std::string_view bytes);

  Connection& connection_;
  Exchange& exchange_;
  std::size_t moved_ = 0;  // bytes read and written
  mutable std::chrono::steady_clock::duration waited_{};
  bool broken_ = false;
};

}  // namespace pelage
