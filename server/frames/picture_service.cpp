#include "server/frames/picture_service.h"

#include "server/frames/trace_cost.h"

namespace pelage {

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

Result<LinearPicture> PictureService::light(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                            const std::function<bool()>& abandoned) {
  if (request.knobs.method != Method::strands) return frames_.light(scene, request, abandoned);
  const auto picture = traces_.trace(scene, request, abandoned);
  return picture ? **picture : Result<LinearPicture>(picture.status());
}

Result<FrameCost> PictureService::cost(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                       const std::function<bool()>& abandoned) {
  if (request.knobs.method != Method::strands) return frames_.cost(scene, request);
  const FrameRequest probe = probe_of(request);
  // The first one also pays for what is then kept for the frame itself.
  if (const auto first = traces_.trace(scene, probe, abandoned); !first) return first.status();
  const auto picture = traces_.trace(scene, probe, abandoned);
  return picture ? trace_cost(request, (*picture)->report) : Result<FrameCost>(picture.status());
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
