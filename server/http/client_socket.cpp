#include "server/http/client_socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <charconv>
#include <filesystem>
#include <string>

namespace pelage {

namespace {

bool comes_from(int descriptor, const httplib::Request& request) {
  sockaddr_storage peer{};
  socklen_t size = sizeof peer;
  if (getpeername(descriptor, reinterpret_cast<sockaddr*>(&peer), &size) != 0) return false;
  char address[INET6_ADDRSTRLEN] = "";
  int port = -1;
  if (peer.ss_family == AF_INET) {
    const auto& v4 = reinterpret_cast<const sockaddr_in&>(peer);
    inet_ntop(AF_INET, &v4.sin_addr, address, sizeof address);
    port = ntohs(v4.sin_port);
  } else if (peer.ss_family == AF_INET6) {
    const auto& v6 = reinterpret_cast<const sockaddr_in6&>(peer);
    inet_ntop(AF_INET6, &v6.sin6_addr, address, sizeof address);
    port = ntohs(v6.sin6_port);
  }
  return port == request.remote_port && request.remote_addr == address;
}

}  // namespace

ClientSocket::ClientSocket(const httplib::Request& request) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string name = entry.path().filename();
    int descriptor = -1;
    std::from_chars(name.data(), name.data() + name.size(), descriptor);
    if (comes_from(descriptor, request)) descriptor_ = descriptor;
  }
}

bool ClientSocket::gone() const {
  char byte = 0;
  return descriptor_ >= 0 && recv(descriptor_, &byte, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
}

}  // namespace pelage
