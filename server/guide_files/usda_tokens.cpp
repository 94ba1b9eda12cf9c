#include "server/guide_files/usda_tokens.h"

#include <algorithm>

namespace pelage {

namespace {

constexpr std::string_view marks = "()[]{}=,;";
constexpr std::string_view ends_of_words = "()[]{}=,; \t\r\n\"'@<#";

}  // namespace

void UsdaTokens::skip_blanks() {
  while (!rest_.empty()) {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
    if (!rest_.starts_with('#')) return;
    rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
  }
}

UsdaToken UsdaTokens::take_front(UsdaToken::Kind kind, std::size_t size) {
  const UsdaToken token{kind, rest_.substr(0, size)};
  rest_.remove_prefix(token.text.size());
  return token;
}

UsdaToken UsdaTokens::take_until(std::string_view quote) {
  std::size_t end = 0;
  while (end < rest_.size() && !rest_.substr(end).starts_with(quote)) end += rest_[end] == '\\' ? 2 : 1;
  const UsdaToken token = take_front(UsdaToken::Kind::text, std::min(end, rest_.size()));
  rest_.remove_prefix(std::min(quote.size(), rest_.size()));
  return token;
}

UsdaToken UsdaTokens::take() {
  skip_blanks();
  if (rest_.empty()) return {};
  for (const std::string_view quote : {"\"\"\"", "'''", "\"", "'", "@@@", "@"}) {
    if (!rest_.starts_with(quote)) continue;
    rest_.remove_prefix(quote.size());
    return take_until(quote);
  }
  if (rest_.front() == '<') {
    rest_.remove_prefix(1);
    return take_until(">");
  }
  if (marks.find(rest_.front()) != std::string_view::npos) return take_front(UsdaToken::Kind::mark, 1);
  return take_front(UsdaToken::Kind::word,
                    std::max<std::size_t>(1, std::min(rest_.find_first_of(ends_of_words), rest_.size())));
}

void UsdaTokens::skip_group() {
  for (int depth = 1; depth > 0;) {
    const UsdaToken token = take();
    if (token.kind == UsdaToken::Kind::end) return;
    if (token.is('(') || token.is('[') || token.is('{')) ++depth;
    if (token.is(')') || token.is(']') || token.is('}')) --depth;
  }
}

void UsdaTokens::skip_value() {
  const UsdaToken token = take();
  if (token.is('(') || token.is('[') || token.is('{')) skip_group();
}

}  // namespace pelage
