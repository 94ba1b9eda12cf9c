#version 450 core
#include "fragment.glsl"

flat in vec4 quad;

void main() { put_fragment(vec4(vec3(quad.y * quad.z), quad.z)); }
