#version 450 core
in vec3 world_position;

uniform vec3 axis;
uniform float offset;

layout(location = 0) out float depth;  // linear depth of the skin or the hull, sizes

void main() { depth = dot(axis, world_position) + offset; }
