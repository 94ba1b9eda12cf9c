#include "server/http/accept_format.h"

#include "server/http/accept_list.h"

namespace pelage {

FrameFormat accepted_format(std::string_view accept) {
  const AcceptList list(accept);
  FrameFormat best = FrameFormat::png;
  double max_weight = list.weight("image/png").value_or(0);
  const auto offer = [&](FrameFormat format, const char* name) {
    const double weight = list.weight(name).value_or(0);
    if (weight > max_weight) best = format, max_weight = weight;
  };
  offer(FrameFormat::jpeg, "image/jpeg");
  offer(FrameFormat::webp, "image/webp");
  return best;
}

}  // namespace pelage
