#include "server/log/server_log.h"

#include <fmt/format.h>
#include <poll.h>
#include <spdlog/logger.h>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <mutex>

#include "protocol/json/encode.h"

namespace pelage {

namespace {

constexpr std::size_t max_text_bytes = 300;  // keeps lines below 4096 bytes, which a pipe writes atomically
constexpr int slow_reader_milliseconds = 200;

bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < 127 && c != '"' && c != '\\'; });
}

/// Returns the value as it is written in a line. A text is quoted if it is not one word, and always with `quoted`.
std::string text_of(const LogField& field, bool quoted) {
  if (const auto* number = std::get_if<std::int64_t>(&field.value)) return fmt::format("{}", *number);
  if (const auto* number = std::get_if<double>(&field.value)) return fmt::format("{:.3f}", *number);
  const std::string_view text = std::get<std::string_view>(field.value).substr(0, max_text_bytes);
  return quoted || !is_plain(text) ? json_text(text) : std::string(text);
}

bool is_left_out(const LogField& field) {
  const auto* text = std::get_if<std::string_view>(&field.value);
  return text && text->empty();
}

std::string line_of(LogFormat format, std::string_view event, std::initializer_list<LogField> fields) {
  const bool json = format == LogFormat::json;
  std::string line = json ? fmt::format("\"event\":\"{}\"", event) : std::string(event);
  for (const LogField& field : fields) {
    if (is_left_out(field)) continue;
    if (json)
      line += fmt::format(",\"{}\":{}", field.name, text_of(field, true));
    else
      line += fmt::format(" {}={}", field.name, text_of(field, false));
  }
  return line;
}

std::unique_ptr<spdlog::formatter> formatter_of(LogFormat format) {
  const char* pattern =
      format == LogFormat::json ? R"({"time":"%Y-%m-%dT%H:%M:%S.%eZ","level":"%l",%v})" : "%Y-%m-%dT%H:%M:%S.%eZ %l %v";
  return std::make_unique<spdlog::pattern_formatter>(pattern, spdlog::pattern_time_type::utc);
}

/// Writes whole lines to a file, a pipe or a terminal. Waits a moment for a slow reader, but not while dropping lines.
class DescriptorSink : public spdlog::sinks::base_sink<std::mutex> {
 public:
  DescriptorSink(LogFormat format, int descriptor) : format_(format), descriptor_(descriptor) {}

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    if (!has_room()) {
      ++dropped_;
      return;
    }
    if (dropped_ > 0) {
      const std::string text = line_of(format_, "lines_dropped", {{"count", std::exchange(dropped_, 0)}});
      put({message.logger_name, spdlog::level::warn, text});
    }
    if (has_room())
      put(message);
    else
      ++dropped_;
  }
  void flush_() override {}

  bool has_room() const {
    pollfd file{descriptor_, POLLOUT, 0};
    return poll(&file, 1, dropped_ > 0 ? 0 : slow_reader_milliseconds) > 0 && (file.revents & POLLOUT) != 0;
  }

  void put(const spdlog::details::log_msg& message) {
    spdlog::memory_buf_t line;
    formatter_->format(message, line);
    while (::write(descriptor_, line.data(), line.size()) < 0 && errno == EINTR) {
    }
  }

  const LogFormat format_;
  const int descriptor_;
  std::int64_t dropped_ = 0;
};

spdlog::level::level_enum level_of(LogLevel level) {
  switch (level) {
    case LogLevel::info: return spdlog::level::info;
    case LogLevel::warning: return spdlog::level::warn;
    case LogLevel::error: return spdlog::level::err;
    case LogLevel::off: return spdlog::level::off;
  }
  return spdlog::level::info;
}

}  // namespace

struct ServerLog::Impl {
  LogFormat format;
  spdlog::logger logger;
};

ServerLog::ServerLog(LogFormat format, LogLevel level, int descriptor)
    : impl_(new Impl{format, spdlog::logger("pelage", std::make_shared<DescriptorSink>(format, descriptor))}) {
  impl_->logger.set_formatter(formatter_of(format));
  impl_->logger.set_level(level_of(level));
}

ServerLog::~ServerLog() = default;

void ServerLog::write(LogLevel level, std::string_view event, std::initializer_list<LogField> fields) const {
  if (!impl_->logger.should_log(level_of(level))) return;
  impl_->logger.log(level_of(level), line_of(impl_->format, event, fields));
}

}  // namespace pelage
