// Lists of fragments, one for each pixel of a region of the picture (Yang et al. 2010). Indices count from 1; 0 ends a
// list. renderer/shells/sorted mirrors the layout.
#include "constants.glsl"
layout(std430, binding = fragment_lists_storage) coherent buffer FragmentLists {
  uint count;      // number of fragments; above `capacity` the lists are incomplete
  uint capacity;
  int left, top;   // of the region, pixels
  int width;
  uint unsorted;   // 1 if a list was not sorted yet
  uint too_long;   // 1 if a list has more fragments than one draw can traverse
  uint padding;
  uint firsts[];   // index of each pixel's first fragment
} lists;
layout(std430, binding = fragment_links_storage) coherent buffer FragmentLinks { uvec2 links[]; };  // bits of the depth; index of the next
layout(std430, binding = fragment_colours_storage) coherent buffer FragmentColours { vec4 fragment_colours[]; };  // premultiplied

const uint in_order = 0x80000000u;  // set in `firsts` once a list is sorted
const uint max_steps = 60000u;     // of a loop: llvmpipe silently ends loops after 65,535 steps

int pixel_of_list() { return (int(gl_FragCoord.y) - lists.top) * lists.width + int(gl_FragCoord.x) - lists.left; }
