// Simple colour maps, sRGB.

// Where a direction points: red to the right, then yellow, green up, blue to the left and violet down; paler the shorter.
vec3 hue_of(vec2 direction) {
  float strength = min(length(direction), 1.0);
  float turn = strength > 1e-6 ? atan(direction.y, direction.x) / 6.28318531 : 0.0;
  vec3 pure = clamp(abs(fract(turn + vec3(0.0, 0.66666667, 0.33333333)) * 6.0 - 3.0) - 1.0, 0.0, 1.0);
  return mix(vec3(1.0), pure, strength);
}

// Dark violet for 0, then blue, green and yellow for 1: lightness rises evenly (viridis in five steps).
vec3 ramp_of(float share) {
  const vec3 steps[5] = vec3[5](vec3(0.267, 0.005, 0.329), vec3(0.230, 0.322, 0.546), vec3(0.128, 0.567, 0.551),
                                vec3(0.369, 0.789, 0.383), vec3(0.993, 0.906, 0.144));
  float at = clamp(share, 0.0, 1.0) * 4.0;
  int low = int(min(at, 3.0));
  return mix(steps[low], steps[low + 1], at - float(low));
}
