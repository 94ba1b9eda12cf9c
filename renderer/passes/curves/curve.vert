#version 450 core
#include "frame.glsl"
#include "ribbon.glsl"

struct CurveStyle {
  vec4 root;    // colour, width
  vec4 tip;
  vec4 normal;  // of the skin at the root; random number
};
layout(std430, binding = curve_points_storage) readonly buffer CurvePoints { vec4 points[]; };  // place, height in the fur
layout(std430, binding = curve_styles_storage) readonly buffer CurveStyles { CurveStyle styles[]; };
layout(std430, binding = curve_numbers_storage) readonly buffer CurveNumbers { uint numbers[]; };

uniform int first;     // of the numbers to draw
uniform int segments;

out vec3 place;
out vec3 tangent;
out vec3 colour;
flat out vec3 normal;
flat out float number;
out float across;      // from the middle of the curve, pixels
out float reach;       // half of the drawn width, pixels
out float strength;    // opacity in the middle

// One curve for each instance: pairs of vertices from the root on, spread across the view.
void main() {
  uint curve = numbers[first + gl_InstanceID];
  CurveStyle style = styles[curve];
  int root = int(curve) * (segments + 1), at = gl_VertexID / 2;
  float side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
  vec4 point = points[root + at];
  place = point.xyz;
  tangent = safe_unit(points[root + min(at + 1, segments)].xyz - points[root + max(at - 1, 0)].xyz);
  vec4 looks = mix(style.root, style.tip, float(at) / float(segments));
  colour = looks.rgb;
  normal = style.normal.xyz;
  number = style.normal.w;

  Ribbon ribbon = ribbon_at(place, tangent, looks.w, side);
  across = ribbon.across;
  reach = ribbon.reach;
  float facing = abs(dot(safe_unit(frame.viewpoint.xyz - points[root].xyz), normal));
  strength = ribbon.strength * mix(seen_through(point.w, facing, nominal_length), 1.0, smoothstep(0.8, 1.1, point.w));
  gl_Position = ribbon.clip;
}
