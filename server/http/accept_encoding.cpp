#include "server/http/accept_encoding.h"

#include "server/http/accept_list.h"

namespace pelage {

std::string_view name_of(ContentCoding encoding) {
  return encoding == ContentCoding::brotli ? "br" : encoding == ContentCoding::gzip ? "gzip" : "";
}

std::optional<ContentCoding> choose_encoding(std::string_view accepted, bool has_gzip, bool has_brotli) {
  constexpr double barely = 1e-9;  // below every weight that a header can state (three decimals)
  const AcceptList list(accepted);
  const std::optional<double> others = list.weight("*");
  std::optional<ContentCoding> best;
  double best_weight = 0;
  const auto offer = [&](ContentCoding encoding, std::optional<double> weight, double unnamed) {
    const double liked = weight.value_or(others.value_or(unnamed));
    if (liked > best_weight) best = encoding, best_weight = liked;
  };
  const auto gzip = list.weight("gzip");
  if (has_brotli) offer(ContentCoding::brotli, list.weight("br"), 0);
  if (has_gzip) offer(ContentCoding::gzip, gzip ? gzip : list.weight("x-gzip"), 0);
  offer(ContentCoding::identity, list.weight("identity"), barely);
  return best;
}

}  // namespace pelage
