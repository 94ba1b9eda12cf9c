// Painted fields at a vertex, handed on to paint.glsl.
#ifdef PAINT
out vec4 amounts;  // density, width, wetness, bare
out vec2 forms;    // curl, clump
#endif
#ifdef PAINT_COLOUR
out vec4 root_paint;  // times its cover, cover
out vec4 tip_paint;
#endif
