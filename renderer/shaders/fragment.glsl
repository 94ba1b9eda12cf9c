// Writes a fragment into the picture or, with SORTED, into its pixel's list.
#include "known.glsl"
#ifdef SORTED
#include "fragment_lists.glsl"

layout(early_fragment_tests) in;  // fragments behind the skin must not enter a list

bool lists_full() { return lists.count > lists.capacity; }

void put_fragment(vec4 colour) {
  if (lists_full()) return;
  uint at = atomicAdd(lists.count, 1u);
  if (at >= lists.capacity) return;
  fragment_colours[at] = known(colour);
  links[at] = uvec2(floatBitsToUint(gl_FragCoord.z), atomicExchange(lists.firsts[pixel_of_list()], at + 1u));
}
#else
layout(location = 0) out vec4 result;  // premultiplied

bool lists_full() { return false; }

void put_fragment(vec4 colour) { result = known(colour); }
#endif
