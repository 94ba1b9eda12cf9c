// One client's connection, and one request on it.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pelage {

/// A client's socket, with the received bytes that nobody has read yet. Its destructor closes the socket.
class Connection {
 public:
  /// Takes ownership of the socket. `address` and `port` are the client's.
  Connection(int socket, std::string address, int port);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  int socket() const { return socket_; }
  const std::string& address() const { return address_; }
  int port() const { return port_; }

  std::string_view unread() const { return std::string_view(received_).substr(read_); }
  void append(const char* bytes, std::size_t size) { received_.append(bytes, size); }
  /// Copies up to `size` unread bytes, marks them as read and returns their number.
  std::size_t take(char* to, std::size_t size);

  int requests = 0;  // number of requests served, with the present one

 private:
  const int socket_;
  const std::string address_;
  const int port_;
  std::string received_;
  std::size_t read_ = 0;
};

/// Returns the size of the first request's head in `bytes`, with the empty line that ends it; none while that line is
/// missing. The first `searched` bytes are known not to have it.
std::optional<std::size_t> head_size(std::string_view bytes, std::size_t searched = 0);

/// Method and target of a request's first line, verbatim; empty if the line is malformed.
struct RequestLine {
  std::string method, target;
};
RequestLine request_line_of(std::string_view head);

/// One request and its answer, as the transport sees them.
struct Exchange {
  Exchange(const Connection& from, std::chrono::steady_clock::time_point begun)
      : connection(from), line(request_line_of(from.unread())), begin(begun) {}

  const Connection& connection;
  RequestLine line;
  std::chrono::steady_clock::time_point begin;  // when its head was complete
  int status = 0;                               // HTTP status of the answer; 0 if none was sent
  std::size_t bytes = 0;                        // size of the answer, with its head
  std::string id;                               // id in the answer and in the log; set by the handlers
  std::string problem;                          // why it was refused or failed; empty if it was not
};

}  // namespace pelage
