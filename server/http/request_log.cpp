#include "server/http/request_log.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <iterator>
#include <random>
#include <string_view>

namespace pelage {

namespace {

constexpr std::size_t version_digits = 2, trace_digits = 32, parent_digits = 16, flag_digits = 2;

bool is_hex(std::string_view text) { return text.find_first_not_of("0123456789abcdef") == text.npos; }
bool is_zero(std::string_view text) { return text.find_first_not_of('0') == text.npos; }

/// Returns the trace id of "00-<trace id>-<parent id>-<flags>"; empty if malformed. Later versions may append fields.
std::string trace_id_of(std::string_view traceparent) {
  std::string_view left = traceparent;
  std::string_view parts[4];
  const std::size_t sizes[] = {version_digits, trace_digits, parent_digits, flag_digits};
  for (std::size_t k = 0; k < std::size(parts); ++k) {
    if (k > 0 && !left.starts_with('-')) return {};
    left.remove_prefix(k > 0 ? 1 : 0);
    parts[k] = left.substr(0, sizes[k]);
    if (parts[k].size() != sizes[k] || !is_hex(parts[k])) return {};
    left.remove_prefix(sizes[k]);
  }
  const bool ends = left.empty() || (parts[0] != "00" && left.starts_with('-'));
  if (!ends || parts[0] == "ff" || is_zero(parts[1]) || is_zero(parts[2])) return {};
  return std::string(parts[1]);
}

LogLevel level_of(int http_status) {
  if (http_status >= 500) return LogLevel::error;
  return http_status >= 400 ? LogLevel::warning : LogLevel::info;
}

}  // namespace

std::string new_request_id(const std::string& traceparent) {
  std::random_device device;
  const std::string trace = trace_id_of(traceparent);
  return fmt::format("{}{}{:08x}{:08x}", trace, trace.empty() ? "" : "-", device(), device());
}

void log_exchange(const ServerLog& log, const Exchange& exchange) {
  const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - exchange.begin;
  log.write(level_of(exchange.status), "request",
            {{"id", exchange.id},
             {"method", exchange.line.method},
             {"path", exchange.line.target},
             {"status", std::int64_t{exchange.status}},
             {"ms", passed.count()},
             {"bytes", static_cast<std::int64_t>(exchange.bytes)},
             {"client", exchange.connection.address()},
             {"problem", exchange.problem}});
}

}  // namespace pelage
