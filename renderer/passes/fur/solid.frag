#version 450 core
#include "frame.glsl"
#include "slab.glsl"

// Depth alone, where the fur is dense; smoothed, so that single strands leave no holes in what lies behind.
void main() {
  if (march(4, 1.0).opacity < 0.93) discard;
}
