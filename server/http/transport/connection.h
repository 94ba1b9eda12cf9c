// One client's connection, and one request on it.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace pelage {

/// A client's socket, with the bytes that came on it and that nobody has read yet. The socket is closed with it.
class Connection {
 public:
  /// Takes the socket over. `address` and `port` are the client's.
  Connection(int socket, std::string address, int port);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  int socket() const { return socket_; }
  const std::string& address() const { return address_; }
  int port() const { return port_; }

  std::string_view unread() const { return std::string_view(received_).substr(read_); }
  void append(const char* bytes, std::size_t size) { received_.append(bytes, size); }
  /// Copies the first `size` unread bytes at most, and counts them as read.
  std::size_t take(char* to, std::size_t size);

  int requests = 0;  // that were answered

 private:
  const int socket_;
  const std::string address_;
  const int port_;
  std::string received_;
  std::size_t read_ = 0;
};

/// The size of the first request's head in `bytes`, with the empty line that ends it; none while that has not come.
/// Bytes before `searched` are known to hold no end.
std::optional<std::size_t> head_size(std::string_view bytes, std::size_t searched = 0);

/// Method and target of a head's first line, as they came; empty where it has none.
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
  std::chrono::steady_clock::time_point begin;  // its head was whole
  int status = 0;                               // of the answer; 0 where none was sent
  std::size_t bytes = 0;                        // of the answer, with its head
  std::string id;                               // what the answer and the log call it by; the handlers set it
  std::string problem;                          // why it was refused or failed; the handlers set it
};

}  // namespace pelage
