// What a request has to be before anything else looks at it.
#pragma once

#include <httplib.h>

#include <optional>
#include <string>
#include <vector>

#include "protocol/base/status.h"

namespace pelage {

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
