// The stream from which cpp-httplib reads a request and to which it writes the answer.
#pragma once

#include <httplib.h>

#include <chrono>
#include <string_view>

#include "server/http/transport/connection.h"

namespace pelage {

/// A connection while one request is served. One wait for the client may take 5 s, and all waits together 30 s and a
/// second more for each 8 kB that are transferred.
class ConnectionStream : public httplib::Stream {
 public:
  ConnectionStream(Connection& connection, Exchange& exchange) : connection_(connection), exchange_(exchange) {}

  bool is_readable() const override;
  bool is_writable() const override;
  /// Returns -1 for a timeout or an error, and 0 at the end.
  ssize_t read(char* to, std::size_t size) override;
  /// Writes all bytes and returns `size`, or returns -1.
  ssize_t write(const char* from, std::size_t size) override;
  void get_remote_ip_and_port(std::string& address, int& port) const override;
  void get_local_ip_and_port(std::string& address, int& port) const override;
  socket_t socket() const override { return connection_.socket(); }

  /// Returns whether a write has failed; nothing more can be sent then.
  bool broken() const { return broken_; }

 private:
  bool wait(short event) const;
  void note_status(std::string_view bytes);

  Connection& connection_;
  Exchange& exchange_;
  std::size_t transferred_ = 0;  // bytes read and written
  mutable std::chrono::steady_clock::duration waited_{};
  bool broken_ = false;
};

}  // namespace pelage
