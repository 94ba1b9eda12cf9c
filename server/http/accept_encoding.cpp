#include "server/http/accept_encoding.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

namespace pelage {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

/// What stands before `end`, or all; `text` keeps what comes after.
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

/// Of "q=0.5"; 1 where there is none.
std::optional<double> weight_of(std::string_view parameters) {
  if (trimmed(parameters).empty()) return 1;
  const std::string text = lower(take_until(parameters, ';'));
  double weight = 0;
  if (!text.starts_with("q=")) return {};
  const auto [stop, error] = std::from_chars(text.data() + 2, text.data() + text.size(), weight);
  if (error != std::errc() || stop != text.data() + text.size() || !(weight >= 0 && weight <= 1)) return {};
  return weight;
}

/// Weights of the encodings; absent where the header does not say.
struct Weights {
  std::optional<double> identity, gzip, brotli, others;
};

Weights weights_of(std::string_view accepted) {
  Weights weights;
  while (!accepted.empty()) {
    std::string_view item = take_until(accepted, ',');
    const std::string name = lower(take_until(item, ';'));
    const auto weight = weight_of(item);
    if (!weight) continue;
    if (name == "br") weights.brotli = weight;
    if (name == "gzip" || name == "x-gzip") weights.gzip = weight;
    if (name == "identity") weights.identity = weight;
    if (name == "*") weights.others = weight;
  }
  return weights;
}

}  // namespace

std::string_view name_of(Encoding encoding) {
  return encoding == Encoding::brotli ? "br" : encoding == Encoding::gzip ? "gzip" : "";
}

std::optional<Encoding> choose_encoding(std::string_view accepted, bool has_gzip, bool has_brotli) {
  constexpr double barely = 1e-9;  // below every weight that can be written: three digits
  const Weights weights = weights_of(accepted);
  const double others = weights.others.value_or(0);
  std::optional<Encoding> best;
  double best_weight = 0;
  const auto offer = [&](Encoding encoding, double weight) {
    if (weight > best_weight) best = encoding, best_weight = weight;
  };
  if (has_brotli) offer(Encoding::brotli, weights.brotli.value_or(others));
  if (has_gzip) offer(Encoding::gzip, weights.gzip.value_or(others));
  offer(Encoding::identity, weights.identity.value_or(weights.others.value_or(barely)));
  return best;
}

}  // namespace pelage
