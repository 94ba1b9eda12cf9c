#version 450 core
#include "tufts.glsl"

uniform float height;
uniform int asked;  // 0: vector to the root, how far it is gathered; 1: lean, share of the optical depth

layout(location = 0) out vec4 result;

void main() {
  Tuft tuft = tuft_here();
  result = vec4(tuft_offset(tuft, height), gathered(tuft, height));
  if (asked == 1) result = vec4(tuft_lean(tuft, height), tuft_share(tuft, height));
}
