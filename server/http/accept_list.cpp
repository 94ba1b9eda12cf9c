#include "server/http/accept_list.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace pelage {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// Removes the text up to `end`, or all of it, from `text` and returns it trimmed, without `end`.
std::string_view take_until(std::string_view& text, char end) {
  const std::size_t at = std::min(text.find(end), text.size());
  const std::string_view taken = text.substr(0, at);
  text.remove_prefix(std::min(at + 1, text.size()));
  return trimmed(taken);
}

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Returns the weight of parameters such as "q=0.5"; 1 without parameters, none if they are malformed.
std::optional<double> weight_of(std::string_view parameters) {
  if (trimmed(parameters).empty()) return 1;
  const std::string text = lower(take_until(parameters, ';'));
  double weight = 0;
  if (!text.starts_with("q=")) return {};
  const auto [stop, error] = std::from_chars(text.data() + 2, text.data() + text.size(), weight);
  if (error != std::errc() || stop != text.data() + text.size() || !(weight >= 0 && weight <= 1)) return {};
  return weight;
}

}  // namespace

AcceptList::AcceptList(std::string_view header) {
  while (!header.empty()) {
    std::string_view item = take_until(header, ',');
    const std::string name = lower(take_until(item, ';'));
    if (const auto weight = weight_of(item)) weights_[name] = *weight;
  }
}

std::optional<double> AcceptList::weight(std::string_view name) const {
  const auto found = weights_.find(name);
  return found == weights_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace pelage
