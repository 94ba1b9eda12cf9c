// Checks on the head of a request, a limit on concurrent work, and whether the client is still connected.
#pragma once

#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/status.h"

namespace pelage {

/// The connection that a request came on. Valid while the request is handled.
class ClientSocket {
 public:
  explicit ClientSocket(const httplib::Request& request);

  /// Returns true once the client has closed the connection; false if that is unknown.
  bool gone() const;

 private:
  int descriptor_ = -1;
};

// A limit on how many requests run one costly operation at a time.

class Gate {
 public:
  explicit Gate(int slots) : capacity_(slots), free_slots_(slots) {}

  /// Holds a slot until it is destroyed. Converts to false if no slot was free.
  class Pass {
   public:
    explicit Pass(Gate* gate) : gate_(gate) {}
    Pass(Pass&& other) noexcept : gate_(std::exchange(other.gate_, nullptr)) {}
    Pass& operator=(Pass&&) = delete;
    ~Pass() {
      if (gate_) ++gate_->free_slots_;
    }
    explicit operator bool() const { return gate_ != nullptr; }

   private:
    Gate* gate_;
  };

  [[nodiscard]] Pass enter() {
    if (--free_slots_ >= 0) return Pass(this);
    ++free_slots_;
    return Pass(nullptr);
  }

  /// Number of slots in use, and of all slots.
  int in_use() const { return capacity_ - std::max(free_slots_.load(), 0); }
  int capacity() const { return capacity_; }

 private:
  const int capacity_;
  std::atomic<int> free_slots_;
};

// Checks of a request before anything else reads it.

struct Refusal {
  int http_status;
  Status status;
};

/// Checks the head of a request before its body is read.
class Guard {
 public:
  /// `hosts`: names that are accepted in the header Host besides the loopback ones. With `any_host` no name is checked;
  /// the token protects the server then.
  Guard(std::string token, std::vector<std::string> hosts, bool any_host);

  std::optional<Refusal> refusal(const httplib::Request& request) const;

 private:
  std::optional<Refusal> refused_sender(const httplib::Request& request) const;
  bool is_our_name(const std::string& host) const;
  bool has_token(const httplib::Request& request) const;

  std::string token_;
  std::vector<std::string> hosts_;
  bool any_host_;
};

/// Returns whether the host is 127.x.x.x, "[::1]", "::1" or "localhost".
bool is_loopback_name(const std::string& host);

}  // namespace pelage
