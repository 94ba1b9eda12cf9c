// The server's log: one line for each event, as text or JSON.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <variant>

namespace pelage {

enum class LogFormat { text, json };
enum class LogLevel { info, warning, error, off };  // lines below it are left out

/// A field of a line. A field with an empty text is left out; a text over 300 bytes is cut.
struct LogField {
  std::string_view name;  // a plain word
  std::variant<std::string_view, std::int64_t, double> value;
};

/// Thread-safe. Each line goes out by one write, with its time in UTC:
///   2026-11-27T05:37:05.123Z info request id=6f1c path=/livez ms=0.3
///   {"time":"2026-11-27T05:37:05.123Z","level":"info","event":"request","id":"6f1c","path":"/livez","ms":0.3}
/// If the reader of the log stalls, lines are dropped, and the first line afterwards gives their number.
class ServerLog {
 public:
  /// Writes to `descriptor`, which the caller owns.
  ServerLog(LogFormat format, LogLevel level, int descriptor);
  ~ServerLog();

  /// `event` is a plain word.
  void write(LogLevel level, std::string_view event, std::initializer_list<LogField> fields) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
