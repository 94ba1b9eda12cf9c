#include "server/frames/picture_service.h"

#include "server/frames/trace_cost.h"

namespace pelage {

Result<PictureService::Encode> PictureService::begin_frame(const std::shared_ptr<Scene>& scene,
                                                           const FrameRequest& request,
                                                           const std::function<bool()>& abandoned) {
  // The state of the scene: a snapshot, which commands do not change.
  Result<FrameView> view = frames_.view(*scene, request);
  if (!view) return view.status();

  // The knobs, chosen if a budget or an error is given, and the expected cost.
  const bool traced = request.knobs.method == Method::strands;
  Result<FramePlan> plan = traced ? FramePlan{request.knobs} : frames_.plan(*view, request);
  if (!plan) return plan.status();

  // The picture: traced pass by pass and then finished, or rasterized, where only what has changed is drawn again.
  if (!traced && !request.progressive) traces_.supersede_view(*scene, request);
  Result<DrawnFrame> drawn = traced ? trace(scene, request, abandoned)
                                    : frames_.draw({scene, request, std::move(*view), std::move(*plan), abandoned});
  if (!drawn) return drawn.status();

  // The file, encoded on the thread of the caller.
  return Encode([this, request, picture = std::make_shared<DrawnFrame>(std::move(*drawn))](const FileTexts& texts) {
    return frames_.encode(std::move(*picture), request, texts);
  });
}

Result<DrawnFrame> PictureService::trace(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                         const std::function<bool()>& abandoned) {
  const auto linear = traces_.trace(scene, request, abandoned);
  return linear ? frames_.finish(**linear, request) : linear.status();
}

Result<FrameAnswer> PictureService::frame(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                          const std::function<bool()>& abandoned, const FileTexts& texts) {
  const Result<Encode> encode = begin_frame(scene, request, abandoned);
  if (!encode) return encode.status();
  FrameAnswer answer = (*encode)(texts);
  if (!request.progressive) return answer;
  answer.trace = TraceReport{};
  // If too many wait, the request for a better picture reports that; the first picture is valid anyway.
  static_cast<void>(traces_.improve(scene, request, answer.revision));
  return answer;
}

Result<LinearPicture> PictureService::draw_linear(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                                  const std::function<bool()>& abandoned) {
  if (request.knobs.method != Method::strands) return frames_.draw_linear(scene, request, abandoned);
  const auto picture = traces_.trace(scene, request, abandoned);
  return picture ? **picture : Result<LinearPicture>(picture.status());
}

Result<FrameCost> PictureService::cost(const std::shared_ptr<Scene>& scene, const FrameRequest& request,
                                       const std::function<bool()>& abandoned) {
  if (request.knobs.method != Method::strands) {
    const Result<FrameView> view = frames_.view(*scene, request);
    if (!view) return view.status();
    FrameRequest unlimited = request;
    unlimited.max_seconds = limits::frame_seconds;  // a cost above the request's limit is reported, not refused
    const Result<FramePlan> plan = frames_.plan(*view, unlimited);
    return plan ? Result<FrameCost>(plan->cost) : plan.status();
  }
  const FrameRequest probe = probe_of(request);
  // The first probe also pays for data that is cached for the frame itself, so the second is measured.
  if (const auto first = traces_.trace(scene, probe, abandoned); !first) return first.status();
  const auto picture = traces_.trace(scene, probe, abandoned);
  return picture ? trace_cost(request, (*picture)->report) : Result<FrameCost>(picture.status());
}

Status PictureService::improve(const std::shared_ptr<Scene>& scene, const FrameRequest& request, SeenPicture seen) {
  return traces_.improve(scene, request, seen.revision);
}

bool PictureService::has_better_picture(const Scene& scene, const FrameRequest& request, SeenPicture seen) {
  return traces_.better_picture(scene, request, seen).has_value();
}

std::optional<Result<FrameAnswer>> PictureService::picture_if_better(const Scene& scene, const FrameRequest& request,
                                                                     SeenPicture seen) {
  if (!scene.is_at(seen.revision)) return {};
  const auto better_picture = traces_.better_picture(scene, request, seen);
  if (!better_picture) return {};
  if (!*better_picture) return Result<FrameAnswer>(better_picture->status());
  const FrameRequest traced = traced_request(request);
  Result<DrawnFrame> drawn = frames_.finish(***better_picture, traced);
  return drawn ? frames_.encode(std::move(*drawn), traced) : Result<FrameAnswer>(drawn.status());
}

}  // namespace pelage
