// What all passes that draw the model set before they draw.
#pragma once

#include <array>

#include "renderer/gl/handles.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// Binds the target; depth is reversed, rows come from the top, nothing is culled.
void set_draw_state(const Gl& gl, const RenderTarget& target);
/// Clears the colour to `colour` and the depth to far away.
void clear_target(const Gl& gl, const RenderTarget& target, const std::array<float, 4>& colour);
void draw_list(const Gl& gl, const ModelBuffers::DrawList& list);

}  // namespace pelage
