// The painted fields of a vertex, given as attributes (FurVertex of renderer/skin/fur_vertex.h).

#ifdef PAINT
layout(location = 11) in vec4 vertex_amounts;
layout(location = 12) in vec4 vertex_forms;  // curl, clump
out vec4 amounts;                            // density, width, wetness, bare
out vec2 forms;                              // curl, clump
#endif
#ifdef PAINT_COLOUR
layout(location = 13) in vec4 vertex_root_paint;
layout(location = 14) in vec4 vertex_tip_paint;
out vec4 root_paint;  // colour times cover, cover
out vec4 tip_paint;
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
