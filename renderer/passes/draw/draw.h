// What all passes that draw the model set before they draw.
#pragma once

#include <array>
#include <cstddef>

#include "renderer/gl/handles.h"
#include "renderer/gl/program.h"
#include "renderer/upload/model_buffers.h"

namespace pelage {

/// Binds the target; depth is reversed, rows come from the top, nothing is culled.
void set_draw_state(const Gl& gl, const RenderTarget& target);
void set_draw_state(const Gl& gl, GLuint framebuffer, int width, int height);
/// Colour to `colour`, depth to far away.
void clear_target(const Gl& gl, const RenderTarget& target, const std::array<float, 4>& colour);
void draw_list(const Gl& gl, const ModelBuffers::DrawList& list);

// Strips: one for each instance, pairs of vertices from one end to the other.

/// Elements that count from 0 to at least 2 (segments + 1) are bound. Draws nothing when the count is 0.
void draw_strips(const Gl& gl, int segments, std::size_t count);

/// All strips once, whatever state is set. The program draws from its uniform `first` on, has `segments` and discards
/// what is under its uniform `min_opacity` (where it has one).
void draw_all_strips(const Gl& gl, const Program& program, int segments, std::size_t count);

/// Hairs that are blended, far ones first, in four passes (character rendering; Scheuermann 2004): depth of opaque
/// hair; opaque hair at equal depth; blended hair on surface back-facing, which is the first `back-facing`; blended
/// hair on surface that is front-facing, with depth. The program is in use; it draws from its uniform `first` on and
/// discards what is under its uniform `min_opacity`. Leaves blending off and depth as set_draw_state wants it.
void draw_four_passes(const Gl& gl, const Program& program, int segments, std::size_t back_facing, std::size_t count);

/// All of them at once, without depth, in any order: for programs of the variant SORTED. The rest as above.
void draw_unordered(const Gl& gl, const Program& program, int segments, std::size_t count);

}  // namespace pelage
