#include "server/http/client_gate.h"

#include "protocol/json/author.h"

namespace pelage {

ClientGate::Pass ClientGate::enter(const std::string& client) {
  const std::lock_guard lock(mutex_);
  const auto found = in_use_by_client_.find(client);
  if (in_use_ == capacity_ || (found != in_use_by_client_.end() && found->second == per_client_)) return {nullptr, {}};
  Pass pass(this, client);
  ++in_use_by_client_[client];
  ++in_use_;
  return pass;
}

void ClientGate::leave(const std::string& client) {
  const std::lock_guard lock(mutex_);
  const auto found = in_use_by_client_.find(client);
  if (--found->second == 0) in_use_by_client_.erase(found);
  --in_use_;
}

std::string client_of(const httplib::Request& request) {
  return request.remote_addr + " " + request.get_header_value(author_header);
}

}  // namespace pelage
