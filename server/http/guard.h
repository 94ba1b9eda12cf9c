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

  /// True once the client has closed the connection; false when that cannot be told.
  bool gone() const;

 private:
  int descriptor_ = -1;
};

// A bound on how many requests do one costly thing at a time.

class Gate {
 public:
  explicit Gate(int places) : all_(places), places_(places) {}

  /// Holds a place until it is destroyed; false when there was none left.
  class Pass {
   public:
    explicit Pass(Gate* gate) : gate_(gate) {}
    Pass(Pass&& other) noexcept : gate_(std::exchange(other.gate_, nullptr)) {}
    Pass& operator=(Pass&&) = delete;
    ~Pass() {
      if (gate_) ++gate_->places_;
    }
    explicit operator bool() const { return gate_ != nullptr; }

   private:
    Gate* gate_;
  };

  [[nodiscard]] Pass enter() {
    if (--places_ >= 0) return Pass(this);
    ++places_;
    return Pass(nullptr);
  }

  /// Places that are held, and all there are.
  int held() const { return all_ - std::max(places_.load(), 0); }
  int all() const { return all_; }

 private:
  const int all_;
  std::atomic<int> places_;
};

// Checks of a request before anything else reads it.

struct Refusal {
  int http_status;
  Status status;
};

/// Decides on the head of a request alone; its body is not read yet.
class Guard {
 public:
  /// `hosts`: names that a request may address beside the loopback ones. With `any_host` (the token protects then) the
  /// name is not compared.
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

/// "127.0.0.1", "[::1]", "::1" or "localhost".
bool is_loopback_name(const std::string& host);

}  // namespace pelage
