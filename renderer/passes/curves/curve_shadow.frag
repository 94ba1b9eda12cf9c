#version 450 core
in vec3 place;
in float across;
in float reach;
in float strength;

uniform vec3 axis;
uniform float offset;

layout(location = 0) out vec4 result;

// What a curve lets through on the way from the light, and its linear depth (sizes). Blending multiplies the first three
// and keeps the least of the fourth.
void main() {
  float opacity = strength * clamp(reach + 0.5 - abs(across), 0.0, 1.0);
  if (opacity < 0.004) discard;
  result = vec4(vec3(1.0 - opacity), dot(axis, place) + offset);
}
