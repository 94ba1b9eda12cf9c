// Painted fields (protocol/commands/field.h) where a fragment lies; renderer/upload has the buffers and the block. Before
// what reads them. What no tool has touched is not defined and costs nothing.
#include "constants.glsl"
#ifdef PAINT
layout(std140, binding = paint_binding) uniform PaintBlock {
  vec4 coat;   // the coat's own wetness, curl and turns of the curl; how far clump_map reaches, tiles
} paint_block;

in vec4 amounts;  // density, width, wetness, bare
in vec2 forms;    // curl, clump

// How much of the light fur keeps from what lies below it, over that of the coat.
float painted_depth() { return amounts.x * amounts.y; }
#endif
#ifdef PAINT_COLOUR
in vec4 root_paint;  // times its cover, cover
in vec4 tip_paint;
#endif
