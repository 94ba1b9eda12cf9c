#include "server/calibration/measure.h"

#include <algorithm>
#include <thread>

#include "renderer/compare/compare.h"
#include "server/scene/fur_view.h"

namespace pelage {

CostUnit cost_unit(bool software, int threads) {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return {software, threads > 0 ? threads : all};
}

Knobs reference_knobs(int shells) {
  Knobs knobs = knobs_of(Tier::interactive);
  knobs.shells = shells, knobs.shell_policy = ShellPolicy::uniform, knobs.order = FragmentOrder::sorted;
  knobs.accumulation = Accumulation::full;
  return knobs;
}

FurFrame measured_frame(const SceneView& scene, const CalibrationScene::View& view) {
  FrameRequest request;
  request.width = request.height = view.size;
  request.camera.automatic = view.side;
  request.background = Background::transparent;
  FurFrame frame = make_frame(scene, request);
  frame.camera.eye *= view.distance;
  return frame;
}

std::optional<double> fur_error(const Image& truth, const Image& test) {
  const Mask mask = union_of(alpha_mask(linear_image(truth)), alpha_mask(linear_image(test)));
  const Result<PictureError> error = compare(truth, test, mask);
  if (!error || !error->figures) return {};
  return error->figures->flip.mean;
}

Result<MeasuredView> measure_view(Renderer& renderer, const CostUnit& unit, const SceneView& scene, FurFrame frame,
                                  std::span<const Knobs> ladder, const MeasureOptions& options) {
  MeasuredView measured;
  measured.features = view_features(frame, furred_skin(scene));
  frame.knobs = reference_knobs(options.truth_shells);
  const Result<Image> truth = renderer.draw(frame);
  if (!truth) return truth.status();
  for (const Knobs& knobs : ladder) {
    frame.knobs = knobs;
    double cost = 1e30;
    for (int i = 0; i < options.repetitions; ++i) {
      DrawTimes times;
      const Result<Image> image = renderer.draw(frame, &times);
      if (!image) return image.status();
      cost = std::min(cost, unit.of(times));
      if (i > 0) continue;
      const std::optional<double> error = fur_error(*truth, *image);
      if (!error) return failure(Code::invalid, "nothing is seen in a view that was to be measured");
      measured.error.push_back(*error);
    }
    measured.cost_ms.push_back(std::max(cost, 1e-3));
  }
  return measured;
}

}  // namespace pelage
