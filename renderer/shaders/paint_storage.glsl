// The painted fields of vertices that are read from storage, as those that strands grow from.
#include "constants.glsl"
#include "paint_vertex.glsl"

#ifdef PAINT
layout(std430, binding = paint_storage) readonly buffer PaintBuffer { vec4 values[]; } paint_buffer;
#endif
#ifdef PAINT_COLOUR
layout(std430, binding = paint_colours_storage) readonly buffer PaintColourBuffer { vec4 values[]; } paint_colour_buffer;
#endif

// Of three vertices by their weights.
void hand_on_paint(uvec3 vertices, vec3 weights) {
#ifdef PAINT
  amounts = vec4(0.0), forms = vec2(0.0);
#endif
#ifdef PAINT_COLOUR
  root_paint = vec4(0.0), tip_paint = vec4(0.0);
#endif
  for (int k = 0; k < 3; ++k) {
    uint at = 2u * vertices[k];
#ifdef PAINT
    amounts += weights[k] * paint_buffer.values[at];
    forms += weights[k] * paint_buffer.values[at + 1u].xy;
#endif
#ifdef PAINT_COLOUR
    root_paint += weights[k] * paint_colour_buffer.values[at];
    tip_paint += weights[k] * paint_colour_buffer.values[at + 1u];
#endif
  }
}
