#include "server/http/transport/connection.h"

#include <unistd.h>

#include <algorithm>

namespace pelage {

Connection::Connection(int socket, std::string address, int port)
    : socket_(socket), address_(std::move(address)), port_(port) {}

Connection::~Connection() { close(socket_); }

std::size_t Connection::take(char* to, std::size_t size) {
  const std::size_t taken = received_.copy(to, size, read_);
  read_ += taken;
  if (read_ == received_.size()) {
    received_.clear();
    read_ = 0;
  }
  return taken;
}

std::optional<std::size_t> head_size(std::string_view bytes, std::size_t searched) {
  static constexpr std::string_view end = "\n\r\n";  // cpp-httplib takes a line without \r for a bad header, not an end
  const std::size_t found = bytes.find(end, searched - std::min(searched, end.size() - 1));
  if (found == bytes.npos) return {};
  return found + end.size();
}

RequestLine request_line_of(std::string_view head) {
  const std::string_view line = head.substr(0, head.find_first_of("\r\n"));
  const std::size_t method_end = line.find(' ');
  if (method_end == line.npos) return {};
  const std::size_t target_end = line.find(' ', method_end + 1);
  if (target_end == line.npos) return {};
  return {std::string(line.substr(0, method_end)),
          std::string(line.substr(method_end + 1, target_end - method_end - 1))};
}

}  // namespace pelage
