// Painted fields (protocol/commands/field.h) at a fragment; renderer/upload has the buffers and the block. Include it
// before code that reads them. Fields that no tool has touched are not defined and cost nothing.
#include "constants.glsl"
#ifdef PAINT
layout(std140, binding = paint_binding) uniform PaintBlock {
  vec4 coat;   // wetness, curl and turns of the curl of the coat; reach of clump_map, tiles
} paint_block;

in vec4 amounts;  // density, width, wetness, bare
in vec2 forms;    // curl, clump

// Returns the painted factor on the coat's optical depth.
float painted_depth() { return amounts.x * amounts.y; }
#endif
#ifdef PAINT_COLOUR
in vec4 root_paint;  // colour times cover, cover
in vec4 tip_paint;
#endif
