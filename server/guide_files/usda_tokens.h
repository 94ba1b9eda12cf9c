// Splits USD as text into tokens.
#pragma once

#include <string_view>

namespace pelage {

/// A token: one of ( ) [ ] { } = , ; or a word, a number, a text without quotes, a path or an asset; empty at the end.
struct UsdaToken {
  enum class Kind { end, mark, word, text } kind = Kind::end;
  std::string_view text = {};

  bool is(char mark) const { return kind == Kind::mark && text.front() == mark; }
};

/// Takes tokens from the front of a text and skips comments. A quote or group that is not closed ends with the file.
class UsdaTokens {
 public:
  explicit UsdaTokens(std::string_view text) : rest_(text) {}

  UsdaToken take();
  UsdaToken peek() const { return UsdaTokens(*this).take(); }
  /// Skips the rest of a group whose opening mark has been taken, including its closing mark.
  void skip_group();
  /// Skips one value: a group, or a word, text or path.
  void skip_value();

 private:
  void skip_blanks();
  UsdaToken take_until(std::string_view quote);
  UsdaToken take_front(UsdaToken::Kind kind, std::size_t size);

  std::string_view rest_;
};

}  // namespace pelage
