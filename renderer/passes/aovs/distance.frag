#version 450 core
// One over the distance along the view, which is the skin's w.
#include "inverse_distance.glsl"

layout(location = 0) out vec4 result;

void main() { result = vec4(inverse_distance(), 0.0, 0.0, 1.0); }
