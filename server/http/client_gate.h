// A limit on concurrent runs of one costly operation, over all clients and for each client.
#pragma once

#include <httplib.h>

#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace pelage {

/// Thread-safe.
class ClientGate {
 public:
  /// Admits `capacity` requests at a time, `per_client` of one client. With `per_client` < `capacity` no client locks
  /// the others out.
  ClientGate(int capacity, int per_client) : capacity_(capacity), per_client_(per_client) {}

  /// Holds a slot until it is destroyed. Converts to false if no slot was free.
  class Pass {
   public:
    Pass(ClientGate* gate, std::string client) : gate_(gate), client_(std::move(client)) {}
    Pass(Pass&& other) noexcept : gate_(std::exchange(other.gate_, nullptr)), client_(std::move(other.client_)) {}
    Pass& operator=(Pass&&) = delete;
    ~Pass() {
      if (gate_) gate_->leave(client_);
    }
    explicit operator bool() const { return gate_ != nullptr; }

   private:
    ClientGate* gate_;
    std::string client_;
  };

  [[nodiscard]] Pass enter(const std::string& client);

  int capacity() const { return capacity_; }
  int per_client() const { return per_client_; }

 private:
  void leave(const std::string& client);

  const int capacity_, per_client_;
  std::mutex mutex_;
  int in_use_ = 0;
  std::map<std::string, int> in_use_by_client_;
};

/// Returns a key for the client of a request: its address and, as clients behind a proxy share one, its Pelage-Author.
std::string client_of(const httplib::Request& request);

}  // namespace pelage
