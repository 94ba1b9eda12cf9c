// Buffers small writes to a sink.
#pragma once

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "server/export/export_file.h"

namespace pelage {

class Buffered {
 public:
  explicit Buffered(const Sink& sink) : sink_(sink) { text_.reserve(2 * chunk_bytes); }

  template <class... Values>
  void print(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
    if (text_.size() >= chunk_bytes) flush();
  }
  template <class Value>
  void put(const Value& value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof(value));
    if (text_.size() >= chunk_bytes) flush();
  }

  bool going() const { return going_; }
  /// Writes the rest to the sink. Returns false if the sink has ended the writing.
  bool finish() {
    flush();
    return going_;
  }

 private:
  static constexpr std::size_t chunk_bytes = std::size_t{1} << 18;

  void flush() {
    if (going_ && !text_.empty()) going_ = sink_(text_);
    text_.clear();
  }

  const Sink& sink_;
  std::string text_;
  bool going_ = true;
};

}  // namespace pelage
