#include "server/http/accept_format.h"

#include "server/http/accept_list.h"

namespace pelage {

FrameFormat accepted_format(std::string_view accept) {
  const AcceptList list(accept);
  FrameFormat best = FrameFormat::png;
  double most = list.weight("image/png").value_or(0);
  const auto offer = [&](FrameFormat format, const char* name) {
    const double liked = list.weight(name).value_or(0);
    if (liked > most) best = format, most = liked;
  };
  offer(FrameFormat::jpeg, "image/jpeg");
  offer(FrameFormat::webp, "image/webp");
  return best;
}

}  // namespace pelage
