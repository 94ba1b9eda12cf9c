// Finds the strand that a frame shows at a pixel.
#pragma once

#include <memory>
#include <optional>

#include "protocol/commands/answers.h"
#include "protocol/commands/pick.h"
#include "server/frames/frame_service.h"

namespace pelage {

/// Returns whether the request asks for a strand: it names a pixel and does not restrict the pick to skin.
bool asks_for_strand(const PickRequest& wanted);

/// Returns the strand that covers most of the pixel in an interactive frame of the view, of which only that pixel is
/// drawn; nothing if skin, an eye or the background covers more. Fails as FrameService::draw_linear does.
Result<std::optional<PickedStrand>> strand_at_pixel(FrameService& frames, const std::shared_ptr<Scene>& scene,
                                                    const View& view, glm::dvec2 pixel);

}  // namespace pelage
