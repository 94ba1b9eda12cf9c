#include "server/surface/mesh.h"

#include <algorithm>

namespace pelage {

void RawModel::add_loss(const std::string& code, const std::string& name, std::size_t count) {
  auto loss = std::find_if(losses.begin(), losses.end(), [&](const Repair& known) { return known.code == code; });
  if (loss == losses.end()) loss = losses.insert(losses.end(), {code, 0});
  loss->count += count;
  const bool is_known = std::find(loss->names.begin(), loss->names.end(), name) != loss->names.end();
  if (!name.empty() && !is_known && loss->names.size() < named_losses) loss->names.push_back(name);
}

}  // namespace pelage
