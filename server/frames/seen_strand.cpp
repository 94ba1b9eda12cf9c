#include "server/frames/seen_strand.h"

#include <algorithm>
#include <cmath>

namespace pelage {

namespace {

constexpr int max_side = 2048;  // pixels; larger views are drawn smaller, because a frame allocates all of its pixels

FrameRequest pixel_request(const View& view, glm::dvec2 pixel) {
  const int part = (std::max(view.width, view.height) + max_side - 1) / max_side;
  FrameRequest request;
  request.camera = view.camera;
  request.width = std::max(view.width / part, 1), request.height = std::max(view.height / part, 1);
  request.format = FrameFormat::exr;
  request.aovs = {Aov::strand, Aov::root};
  const auto within = [](double at, int from, int to) {
    return std::clamp(static_cast<int>(std::floor(at * to / from)), 0, to - 1);
  };
  request.crop = Crop{.left = within(pixel.x, view.width, request.width),
                      .top = within(pixel.y, view.height, request.height),
                      .width = 1,
                      .height = 1};
  return request;
}

}  // namespace

bool asks_for_strand(const PickRequest& wanted) {
  return wanted.reach == Reach::fur && !wanted.ray && !wanted.farthest && !wanted.nearest;
}

Result<std::optional<PickedStrand>> strand_at_pixel(FrameService& frames, const std::shared_ptr<Scene>& scene,
                                                    const View& view, glm::dvec2 pixel) {
  const FrameRequest request = pixel_request(view, pixel);
  const Result<LinearPicture> picture = frames.draw_linear(scene, request);
  if (!picture) return picture.status();
  const std::size_t at = 4 * (static_cast<std::size_t>(request.crop->top) * static_cast<std::size_t>(request.width) +
                              static_cast<std::size_t>(request.crop->left));
  const float *strand = &picture->aovs[0].rgba[at], *root = &picture->aovs[1].rgba[at];
  if (!(strand[0] > 0)) return std::optional<PickedStrand>();
  PickedStrand picked;
  picked.id = static_cast<int>(strand[0]);
  picked.along = std::clamp(double{strand[1]}, 0.0, 1.0);
  const auto number = static_cast<std::size_t>(strand[2]);  // of its coat, from 1
  picked.kind = number > limits::coats ? StrandKind::curve : StrandKind::coat;
  for (const NamedCoat& coat : picture->frame->coats)
    if (coat.id + 1 == number) picked.coat = coat.name;
  picked.root = picture->placement.centre + picture->placement.size * glm::dvec3(root[0], root[1], root[2]);
  return std::optional(picked);
}

}  // namespace pelage
