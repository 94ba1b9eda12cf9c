#include "server/http/client_gate.h"

#include "protocol/json/author.h"

namespace pelage {

ClientGate::Pass ClientGate::enter(const std::string& client) {
  const std::lock_guard lock(mutex_);
  const auto found = held_by_.find(client);
  if (held_ == all_ || (found != held_by_.end() && found->second == each_)) return {nullptr, {}};
  Pass pass(this, client);
  ++held_by_[client];
  ++held_;
  return pass;
}

void ClientGate::leave(const std::string& client) {
  const std::lock_guard lock(mutex_);
  const auto found = held_by_.find(client);
  if (--found->second == 0) held_by_.erase(found);
  --held_;
}

std::string client_of(const httplib::Request& request) {
  return request.remote_addr + " " + request.get_header_value(author_header);
}

}  // namespace pelage
