#include "server/frames/frame_queue.h"

#include <algorithm>
#include <thread>

namespace pelage {

CostUnit cost_unit(bool software, int threads) {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return {software, threads > 0 ? threads : all};
}

RendererOptions renderer_options(const CostUnit& unit) { return {.march_threads = unit.software ? unit.threads : 0}; }

std::string drawn_by(const Context& context) {
  return context.description() + (context.is_software() ? "; fur by " + MarchedRenderer::description() : "");
}

double expected_cost(const FrameRequest& request) {
  constexpr double any_frame = 10, shell_pixel = 5e-6, sorted = 4;  // milliseconds; times as much
  constexpr double probe_shells = 256;
  if (request.budget_ms) return any_frame + *request.budget_ms;
  const Knobs& knobs = request.knobs;
  const double pixels = static_cast<double>(request.width) * request.height;
  if (request.max_error) return any_frame + pixels * probe_shells * sorted * shell_pixel;
  const double shells = knobs.scale * knobs.scale * knobs.shells;
  return any_frame + pixels * shells * (knobs.order == FragmentOrder::sorted ? sorted : 1) * shell_pixel;
}

FurredSkin furred_skin(const SceneView& scene) {
  const Mesh& mesh = scene.model.surface.mesh();
  FurredSkin skin{mesh.positions, mesh.normals, mesh.triangles, scene.fields.length()};
  if (!mesh.triangles.empty())
    skin.pieces = static_cast<double>(scene.model.patches.pieces.size()) / static_cast<double>(mesh.triangles.size());
  for (std::size_t field = first_painted; field < field_count; ++field)
    skin.painted = skin.painted || !scene.fields.at_default(field_at(field));
  return skin;
}

}  // namespace pelage
