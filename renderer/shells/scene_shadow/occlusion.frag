#version 450 core
#include "frame.glsl"

in vec3 world_position;
in vec3 skin_normal;

uniform vec3 axis;
uniform float offset;
uniform float bias;  // sizes

layout(binding = depth_maps_unit) uniform sampler2D light_depth;

layout(location = 0) out vec2 occluded;

// The inverted occlusion map (GPU fur 4): 1 where skin that faces the light is occluded, and the depth of its occluder; else
// 0.
void main() {
  if (dot(skin_normal, frame.viewpoint.xyz - world_position) <= 0.0) discard;
  float depth = dot(axis, world_position) + offset;
  float seen = texelFetch(light_depth, ivec2(gl_FragCoord.xy), 0).r;
  occluded = depth > seen + bias ? vec2(1.0, seen) : vec2(0.0);
}
