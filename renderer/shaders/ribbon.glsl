// Ribbons that face the camera: what guard hairs and guided curves share. After frame.glsl.
#include "unit.glsl"

// Share of what a hair shows at height s that the fur before it lets through to the camera: hairs are drawn after the
// shells, and without it their roots would lie over the fur. Sorted, they have their place among the shells.
float seen_through(float s, float facing, float fur_length) {
#ifdef SORTED
  return 1.0;
#endif
  float slice = clamp(s * float(slice_count) - 0.5, 0.0, float(slice_count - 1));
  int low = int(slice), high = min(low + 1, slice_count - 1);
  float above = mix(frame.depth_above[low / 4][low % 4], frame.depth_above[high / 4][high % 4], fract(slice));
  return exp(-above * fur_length / nominal_length * sqrt(max(1.0 - facing * facing, 0.0)) / max(facing, 0.2));
}

struct Ribbon {
  vec4 clip;
  float across;    // from the middle of the ribbon, pixels
  float reach;     // half of the drawn width, pixels
  float strength;  // opacity in the middle
};

// A vertex on one side (-1 or 1) of a ribbon; width in sizes. Thinner than a pixel it is drawn a pixel wide and lets
// more through.
Ribbon ribbon_at(vec3 place, vec3 tangent, float width, float side) {
  vec3 to_camera = frame.viewpoint.xyz - place;
  float pixel = frame.viewpoint.w * length(to_camera), pixels = width / max(pixel, 1e-20);
  float reach = 0.5 * max(pixels, 1.0), across = side * (reach + 0.5);
  vec3 spread_to = safe_unit(cross(safe_unit(tangent), safe_unit(to_camera)));
  vec4 clip = frame.world_to_clip * vec4(place + spread_to * (across * pixel), 1.0);
  return Ribbon(clip, across, reach, min(pixels, 1.0));
}
