// Moves the skin's vertices to a shell, along the curve of the strands: an arc that leaves the skin along the normal
// and ends at an inclination given by the length of `_direction` (1: 90 degrees).
attribute float _length;
attribute float _density;
attribute float _weight;
attribute vec3 _direction;
uniform float layers;
out vec2 coat_uv;   // texture coordinate on the coat's repeating tile
out vec3 tangent;   // of the strand at this vertex
out vec3 view;
out vec3 fur;
out float share;    // fraction of the strands that grow here, [0, 1]
flat out float layer;

const float quarter = 1.5707963;

void main() {
  layer = float(gl_InstanceID);
  float s = (layer + .5) / layers;
  float inclination = min(length(_direction), 1.);
  vec3 along = inclination > 1e-4 ? _direction / inclination : vec3(0);
  float bend = max(inclination * quarter, 1e-3);
  vec3 offset = _length * (sin(s * bend) * normal + (1. - cos(s * bend)) * along) / bend;
  vec4 world = modelMatrix * vec4(position + offset, 1);
  coat_uv = uv;
  tangent = cos(s * bend) * normal + sin(s * bend) * along;
  view = cameraPosition - world.xyz;
  fur = color.rgb;
  share = _density * _weight;
  gl_Position = projectionMatrix * viewMatrix * world;
}
