// A shell is the skin, moved along the curve that each strand follows: an arc that leaves the skin upright and ends as
// far inclined as the direction is long.
attribute float _length;
attribute float _density;
attribute float _weight;
attribute vec3 _direction;
uniform float layers;
out vec2 place;     // on the coat's tile, which repeats
out vec3 tangent;   // of the strand here
out vec3 view;
out vec3 fur;
out float share;    // of the strands that stand here
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
  place = uv;
  tangent = cos(s * bend) * normal + sin(s * bend) * along;
  view = cameraPosition - world.xyz;
  fur = color.rgb;
  share = _density * _weight;
  gl_Position = projectionMatrix * viewMatrix * world;
}
