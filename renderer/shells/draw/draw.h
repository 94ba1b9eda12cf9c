// GL state and draw calls that all passes over the model share.
#pragma once

#include <array>

#include "renderer/gl/handles.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// Binds the target and sets reversed depth, rows from the top and no face culling.
void set_draw_state(const Gl& gl, const RenderTarget& target);
/// Clears the colour to `colour` and the depth, if there is one, to infinitely far.
void clear_target(const Gl& gl, const RenderTarget& target, const std::array<float, 4>& colour);
void draw_list(const Gl& gl, const ModelBuffers::DrawList& list);

}  // namespace pelage
