#include "server/calibration/measure.h"

#include <algorithm>
#include <optional>

#include "server/frames/error_probe.h"
#include "server/frames/fur_view.h"

namespace pelage {

FurFrame measured_frame(const SceneView& scene, const CalibrationScene::View& view) {
  FrameRequest request;
  request.width = request.height = view.size;
  request.camera.automatic = view.side;
  request.background = Background::transparent;
  FurFrame frame = make_frame(scene, request);
  frame.camera.position *= view.distance;
  return frame;
}

namespace {

FurFrame with(FurFrame frame, const Knobs& knobs) {
  frame.knobs = knobs;
  return frame;
}

/// The first picture, and the least cost.
Result<Image> draw_often(Renderer& renderer, const CostUnit& unit, const FurFrame& frame, int repetitions,
                         double& cost) {
  Result<Image> first = failure(Code::internal, "no repetition");
  cost = 1e30;
  for (int i = 0; i < repetitions; ++i) {
    DrawTimes times;
    renderer.clear_view_cache();
    Result<Image> image = renderer.draw(frame, &times);
    if (!image) return image;
    cost = std::min(cost, std::max(unit.of(times), 1e-3));
    if (i == 0) first = std::move(image);
  }
  return first;
}

}  // namespace

Result<MeasuredView> measure_view(Renderer& renderer, const CostUnit& unit, const SceneView& scene,
                                  const FurFrame& frame, std::span<const Knobs> ladder, const MeasureOptions& options) {
  MeasuredView measured;
  measured.features = view_features(frame, furred_skin(scene));
  std::optional<Image> truth;
  if (options.truth_shells > 0) {
    Result<Image> drawn = renderer.draw(with(frame, reference_knobs(options.truth_shells)));
    if (!drawn) return drawn.status();
    truth = std::move(drawn).value();
  }
  for (const Knobs& knobs : ladder) {
    double cost = 0;
    const Result<Image> image = draw_often(renderer, unit, with(frame, knobs), options.repetitions, cost);
    if (!image) return image.status();
    measured.cost_ms.push_back(cost);
    if (!truth) continue;
    const std::optional<FurError> error = fur_error(*truth, *image);
    if (!error) return failure(Code::invalid, "nothing is seen in a view that was to be measured");
    measured.error.push_back(error->mean);
  }
  measured.probed_error.resize(ladder.size());
  ErrorProbe probe(renderer, frame, measured.features.places, std::max(options.truth_shells, 1));
  for (std::size_t row = 0; options.probed > 0 && row < ladder.size(); row += static_cast<std::size_t>(options.probed))
    measured.probed_error[row] = probe.error(ladder[row]).value_or(0);
  return measured;
}

}  // namespace pelage
