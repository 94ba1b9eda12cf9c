// Lists of fragments, one for each pixel of an area of the picture (Yang et al. 2010). Places count from 1; 0 ends a
// list. renderer/shells/sorted mirrors the layout.
#include "constants.glsl"
layout(std430, binding = fragment_lists_storage) coherent buffer FragmentLists {
  uint count;      // of fragments; over `capacity` the lists are not whole
  uint capacity;
  int left, top;   // of the area, pixels
  int width;
  uint unsorted;   // 1 when a list was not in order yet
  uint too_long;   // 1 when a list has more fragments than one draw can walk over
  uint padding;
  uint firsts[];   // of each pixel
} lists;
layout(std430, binding = fragment_links_storage) coherent buffer FragmentLinks { uvec2 links[]; };  // bits of the depth; the next place
layout(std430, binding = fragment_colours_storage) coherent buffer FragmentColours { vec4 fragment_colours[]; };  // premultiplied

const uint in_order = 0x80000000u;  // set in `firsts` once a list is sorted
const uint max_steps = 60000u;     // of a loop: llvmpipe ends loops after 65,535 steps, in silence

int pixel_of_list() { return (int(gl_FragCoord.y) - lists.top) * lists.width + int(gl_FragCoord.x) - lists.left; }
