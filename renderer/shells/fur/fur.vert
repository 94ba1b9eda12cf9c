#version 450 core
#include "fur_vertex.glsl"

void main() { place_vertex(); }
