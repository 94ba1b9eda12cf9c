#include "server/http/accept_encoding.h"

#include "server/http/accept_list.h"

namespace pelage {

std::string_view name_of(Encoding encoding) {
  return encoding == Encoding::brotli ? "br" : encoding == Encoding::gzip ? "gzip" : "";
}

std::optional<Encoding> choose_encoding(std::string_view accepted, bool has_gzip, bool has_brotli) {
  constexpr double barely = 1e-9;  // below every weight that can be written: three digits
  const AcceptList list(accepted);
  const std::optional<double> others = list.weight("*");
  std::optional<Encoding> best;
  double best_weight = 0;
  const auto offer = [&](Encoding encoding, std::optional<double> weight, double unnamed) {
    const double liked = weight.value_or(others.value_or(unnamed));
    if (liked > best_weight) best = encoding, best_weight = liked;
  };
  const auto gzip = list.weight("gzip");
  if (has_brotli) offer(Encoding::brotli, list.weight("br"), 0);
  if (has_gzip) offer(Encoding::gzip, gzip ? gzip : list.weight("x-gzip"), 0);
  offer(Encoding::identity, list.weight("identity"), barely);
  return best;
}

}  // namespace pelage
