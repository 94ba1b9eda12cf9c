// The painted fields of a vertex that comes as attributes (renderer/upload/paint_buffers.h).
#include "paint_vertex.glsl"

#ifdef PAINT
layout(location = 11) in vec4 vertex_amounts;
layout(location = 12) in vec4 vertex_forms;  // curl, clump, mask
#endif
#ifdef PAINT_COLOUR
layout(location = 13) in vec4 vertex_root_paint;
layout(location = 14) in vec4 vertex_tip_paint;
#endif

void hand_on_paint() {
#ifdef PAINT
  amounts = vertex_amounts;
  forms = vertex_forms.xy;
#endif
#ifdef PAINT_COLOUR
  root_paint = vertex_root_paint;
  tip_paint = vertex_tip_paint;
#endif
}
