#include "server/frames/picture_service.h"

#include <algorithm>

namespace pelage {

namespace {

constexpr int probe_reduction = 4, probe_passes = 2;

/// The picture that tells what another one costs.
FrameRequest probe_of(const FrameRequest& request) {
  FrameRequest probe = request;
  probe.width = std::max(1, request.width / probe_reduction),
  probe.height = std::max(1, request.height / probe_reduction);
  probe.crop.reset();
  probe.knobs.trace.passes = probe_passes;
  probe.knobs.trace.noise = probe.knobs.trace.seconds = 0;
  probe.view.clear();
  return probe;
}

/// Growing strands takes the same for any size, a pass as long as there are pixels.
FrameCost cost_of(const FrameRequest& request, const FrameRequest& probe, const TraceReport& report) {
  constexpr double safety = 2;  // docs/notes/2026-11-25-models.md
  const Tracing& trace = request.knobs.trace;
  const auto pixels = [](const FrameRequest& frame) {
    return static_cast<double>(frame.width) * frame.height * frame.drawn_share();
  };
  const double pass_ms = report.trace_ms / probe_passes * pixels(request) / pixels(probe);
  const double seconds = (report.grow_ms + trace.passes * pass_ms) / 1e3;
  return {trace.seconds > 0 ? std::min(seconds, trace.seconds) : seconds, safety};
}

}  // namespace

Result<FrameAnswer> PictureService::frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                          const std::function<bool()>& abandoned, const FileTexts& texts) {
  if (request.knobs.method == Method::strands) {
    const auto picture = traces_.trace(scene, request, abandoned);
    return picture ? frames_.finish(**picture, request, texts) : picture.status();
  }
  if (!request.progressive) traces_.turn_from(*scene, request);
  Result<FrameAnswer> answer = frames_.frame(scene, request, abandoned, texts);
  if (!answer || !request.progressive) return answer;
  answer->trace = TraceReport{};
  // Where too many wait, whoever asks for a better picture is told so; shells are there all the same.
  static_cast<void>(traces_.improve(scene, request, answer->revision));
  return answer;
}

Result<FrameCost> PictureService::cost(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                       const std::function<bool()>& abandoned) {
  if (request.knobs.method != Method::strands) return frames_.cost(scene, request);
  const FrameRequest probe = probe_of(request);
  // The first one also pays for what is then kept for the frame itself.
  if (const auto first = traces_.trace(scene, probe, abandoned); !first) return first.status();
  const auto picture = traces_.trace(scene, probe, abandoned);
  return picture ? cost_of(request, probe, (*picture)->report) : Result<FrameCost>(picture.status());
}

Status PictureService::look(const std::shared_ptr<Scene>& scene, const FrameRequest& request, SeenPicture seen) {
  return traces_.improve(scene, request, seen.revision);
}

bool PictureService::has_better_picture(const Scene& scene, const FrameRequest& request, SeenPicture seen) {
  return traces_.better(scene, request, seen).has_value();
}

std::optional<Result<FrameAnswer>> PictureService::picture_if_better(const Scene& scene, const FrameRequest& request,
                                                                     SeenPicture seen) {
  if (!scene.is_at(seen.revision)) return {};
  const auto better = traces_.better(scene, request, seen);
  if (!better) return {};
  if (!*better) return Result<FrameAnswer>(better->status());
  return frames_.finish(***better, traced_request(request));
}

}  // namespace pelage
