// The lean curves of base/lean_curve.cpp for a strand of length 1: position across and up, and the tangent's angle.
float lean_sinc(float x) { return abs(x) < 1e-2 ? 1.0 - x * x / 6.0 : sin(x) / x; }

float parabola_length(float u) {
  return sqrt(1.0 + u * u) + (abs(u) < 1e-2 ? 1.0 - u * u / 6.0 : asinh(u) / u);
}

vec3 lean_arc(float a0, float a, float s) {
  float x = a * s;
  float chord = s * lean_sinc(0.5 * x);
  return vec3(chord * sin(a0 + 0.5 * x), chord * cos(a0 + 0.5 * x), a0 + x);
}

vec3 lean_root(float a0, float a, float s) {
  float u1 = 2.0 * tan(0.5 * a);
  float total = parabola_length(u1);
  float r = s;
  for (int i = 0; i < 3; ++i) {
    float u = r * u1;
    r -= (r * parabola_length(u) - s * total) / (2.0 * sqrt(1.0 + u * u));
  }
  float y = 2.0 * r / total, x = r * r * u1 / total;
  return vec3(y * sin(a0) + x * cos(a0), y * cos(a0) - x * sin(a0), a0 + atan(r * u1));
}

vec3 lean_point(bool root_curve, float inclination, float root_share, float s) {
  float tip = inclination * 1.57079632679;
  float a0 = root_share * tip;
  return root_curve ? lean_root(a0, tip - a0, s) : lean_arc(a0, tip - a0, s);
}

// Returns the unit direction along the skin in which fur leans, for a value of the direction field; lean_of in
// base/lean_curve.h.
vec3 lean_along(vec2 direction, vec3 normal, vec3 tangent) {
  float inclination = min(length(direction), 1.0);
  vec2 heading = inclination > 1e-6 ? direction / inclination : vec2(1.0, 0.0);
  return tangent * heading.x + cross(normal, tangent) * heading.y;
}

// Height of the fur's hull as a share of the fur's height: fur up to it occludes the light on other parts of the body.
const float hull_height = 0.6;

// Returns the offset from the root to a height, at least that of the hull.
vec3 hull_offset(vec3 groom, vec3 normal, vec3 tangent, bool root_curve, float root_share, float height) {
  float inclination = min(length(groom.xy), 1.0);
  vec3 curve = lean_point(root_curve, inclination, root_share, max(height, hull_height));
  return groom.z * (curve.x * lean_along(groom.xy, normal, tangent) + curve.y * normal);
}
