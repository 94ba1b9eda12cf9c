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
  /// Admits `all` requests at a time, and `each` of one client. Choose `each` < `all`, so that no client locks others
  /// out.
  ClientGate(int all, int each) : all_(all), each_(each) {}

  /// Holds a place until it is destroyed. Converts to false if no place was left.
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

  int all() const { return all_; }
  int each() const { return each_; }

 private:
  void leave(const std::string& client);

  const int all_, each_;
  std::mutex mutex_;
  int held_ = 0;
  std::map<std::string, int> held_by_;
};

/// Returns a key for the client of a request: its address and its Pelage-Author, as clients behind a proxy share one
/// address.
std::string client_of(const httplib::Request& request);

}  // namespace pelage
