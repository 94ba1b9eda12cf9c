// Whether a client still waits for its answer.
#pragma once

#include <httplib.h>

namespace pelage {

/// The connection that a request came on. cpp-httplib does not hand it out, so it is looked up among the sockets of the
/// process by the client's address and port. Valid while the request is handled.
class ClientSocket {
 public:
  explicit ClientSocket(const httplib::Request& request);

  /// True once the client has closed the connection; false when that cannot be told.
  bool gone() const;

 private:
  int descriptor_ = -1;
};

}  // namespace pelage
