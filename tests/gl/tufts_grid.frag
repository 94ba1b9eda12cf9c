#version 450 core
#include "tufts.glsl"

uniform float height;
uniform int asked;  // 0: way to the root, and how far it is gathered; 1: lean, and share of the optical depth

layout(location = 0) out vec4 result;

void main() {
  Tuft tuft = tuft_here();
  result = vec4(tuft_way(tuft, height), gathered(tuft, height));
  if (asked == 1) result = vec4(tuft_lean(tuft, height), tuft_share(tuft, height));
}
