#version 450 core
#include "frame.glsl"
#include "slab.glsl"

// Depth alone, where the fur is dense; smoothed, so that single strands leave no holes in what lies behind. Each patch
// counts fully where it shares a place with others, or their overlap would have holes.
void main() {
  look_around();
  if (march(1, 2.0, 1.0, shell_height(), shell_thickness()).opacity < 0.93) discard;
}
