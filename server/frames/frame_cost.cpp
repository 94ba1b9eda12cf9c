#include "server/frames/frame_cost.h"

#include <algorithm>
#include <thread>

namespace pelage {

CostUnit cost_unit(bool software, int threads) {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return {software, threads > 0 ? threads : all};
}

FurredSkin furred_skin(const SceneView& scene) {
  const Mesh& mesh = scene.model.surface.mesh();
  FurredSkin skin{mesh.positions, mesh.normals, mesh.triangles, scene.fields.length()};
  if (!mesh.triangles.empty())
    skin.pieces = static_cast<double>(scene.model.patches.pieces.size()) / static_cast<double>(mesh.triangles.size());
  for (std::size_t field = first_painted; field < field_count; ++field)
    skin.painted = skin.painted || !scene.fields.at_rest(field_at(field));
  return skin;
}

}  // namespace pelage
