#version 450 core
// Bends strands by wind and body motion: Grower::bend, a strand a lane.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
#include "fur.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = points_storage) readonly buffer Points { vec4 points[]; };
layout(std430, binding = words_storage) readonly buffer Words { uint words[]; };
layout(std430, binding = bends_storage) readonly buffer Bends { vec4 bends[]; };  // TriangleBend of each triangle of the model
layout(std430, binding = leans_storage) readonly buffer Leans { vec4 leans[]; };  // LeanTable::rows
layout(std430, binding = bent_storage) writeonly buffer Bent { vec4 bent[]; };

// Vectors of `bends` for a corner, and where in them its moved lean begins, which follows its still one.
const uint corner_bend = 4, lean = 2;

vec4 lean_knot(float inclination, int k) {
  int rows = leans.length() / (lean_cells + 1);
  float at = clamp(inclination, 0.0, 1.0) * float(rows - 1);
  int low = min(int(at), rows - 2), first = low * (lean_cells + 1) + k;
  return mix(leans[first], leans[first + lean_cells + 1], at - float(low));
}

// Returns LeanCurves::at of a corner: the offset from the root to the height s.
vec3 lean_at(uint first, float s) {
  vec4 up = bends[first], across = bends[first + 1];
  float at = s * float(lean_cells);
  int k = int(clamp(at, 0.0, float(lean_cells) - 1.0));
  float x = at - float(k), y = 1.0 - x;
  vec4 low = lean_knot(across.w, k), high = lean_knot(across.w, k + 1);
  vec2 position = y * y * (1.0 + 2.0 * x) * low.xy + x * x * (1.0 + 2.0 * y) * high.xy;
  position += (x * y * y * low.zw - x * x * y * high.zw) / float(lean_cells);
  return up.w * (position.x * across.xyz + position.y * up.xyz);
}

void main() {
  FurStrand own = fur_strand();
  if (!own.there) return;
  uint knots = uint(own.part.segments + 1);
  uint root = own.part.words + own.part.count * (knots + 1) + own.strand * root_words;
  float reach = uintBitsToFloat(words[root + 4]), stretch = uintBitsToFloat(words[root + 5]);
  uint triangle = words[root + 7], shares = words[root + 8];
  bool moves = triangle != 0xffffffffu;
  vec2 share = vec2(shares & 0xffffu, shares >> 16) / 65535.0;
  vec3 corners = vec3(1.0 - share.x - share.y, share);
  for (uint k = 0; k < knots; ++k) {
    vec4 point = points[own.first + k];
    float s = float(k) / float(own.part.segments) * reach;
    for (uint i = 0; i < 3 && moves; ++i) {
      uint still = (3 * triangle + i) * corner_bend;
      point.xyz += stretch * corners[i] * (lean_at(still + lean, s) - lean_at(still, s));
    }
    bent[own.first + k] = point;
  }
}
