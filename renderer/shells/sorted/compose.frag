#version 450 core
// Blends the sorted list of each pixel front to back. Fragments at the same depth, as of overlapping patches, are mixed so
// that their order does not count: their opacities combine, and their colours are weighted by opacity.
#include "fragment_lists.glsl"

layout(location = 0) out vec4 result;  // premultiplied

void main() {
  uint at = lists.firsts[pixel_of_list()] & ~in_order;
  vec3 light = vec3(0.0);
  float left = 1.0;  // transmittance so far
  for (uint step = 0u; at != 0u && step < max_steps;) {
    uint depth = links[at - 1u].x;
    vec4 sum = vec4(0.0);
    float opacity = 0.0;
    for (; at != 0u && step < max_steps; ++step) {
      uvec2 link = links[at - 1u];
      if (link.x != depth) break;
      vec4 colour = fragment_colours[at - 1u];
      sum += colour;
      opacity += colour.a * (1.0 - opacity);
      at = link.y;
    }
    if (sum.a > 0.0) light += left * opacity / sum.a * sum.rgb;
    left *= 1.0 - opacity;
  }
  result = vec4(light, 1.0 - left);
}
