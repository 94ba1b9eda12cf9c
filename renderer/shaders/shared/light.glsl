// Light on fur: the light that arrives, and the share that fur transmits. Reads the block `frame`; the includer defines
// directional_lights and white_surroundings.

// What lies between a position and a light: number of strands, and optical depth of the body.
struct Crossing {
  Real strands, body;
};

FUNCTION Arriving light_at(Index i, Vec3 position) {
  LightBlock light = frame.lights[i];
  Arriving arriving;
  arriving.to_light = -Vec3(light.direction);
  arriving.radiance = Vec3(light.radiance);
  if (directional_lights) return arriving;
  Vec3 apart = Vec3(light.position) - position;
  Real square = max(dot(apart, apart), float(min_light_square));
  if (light.direction.w > 0.5f) {  // not a directional light
    arriving.to_light = apart * (1.0f / sqrt(square));
    arriving.radiance = arriving.radiance * min(1.0f / square, float(max_light_falloff));
  }
  float edge = light.position.w, width = light.radiance.w - edge;
  Real inside = -dot(arriving.to_light, Vec3(light.direction));
  arriving.radiance = arriving.radiance * clamp((inside - edge) / max(width, 1e-6f), 0.0f, 1.0f);
  return arriving;
}

// Returns the share of the light that a strand of that colour stops, for `part` of its thickness. Light that passes
// pale fur keeps its colour and much of its strength: t_c = t^(1 - f_c) (science.md 4), with t = exp(-2) past a black
// strand.
FUNCTION Vec3 stopped_by_strand(Vec3 colour, float part) {
  float black = -2.0f * 1.442695f * part * frame.exponents.w;
  return Vec3(1.0f) - exp2(black * (Vec3(1.0f) - 0.82f * sqrt(clamp(colour, 0.0f, 1.0f))));
}

// Returns the share of ambient light that reaches a height: g of GPU fur eq 1. Without self-shadow it depends on s
// alone. With self-shadow the strands above are known and take the place of s; both together would darken the same fur
// twice. A ray at the angle x to the normal crosses `above` tan x strands and is weighted by cos x. The mean of exp(-a
// tan x) over the hemisphere falls by pi/2 a for small a and as 2 / a^2 for large a; this fit is within .01. `stopped`
// is for .6 of a strand's thickness.
FUNCTION Vec3 ambient_share(Real height, Real above, Vec3 stopped) {
  Vec3 a = above * stopped, one = Vec3(1.0f);
  Vec3 reached = (one + a) / (one + a * (Vec3(2.5707963f) + a * (Vec3(1.21f) + a * 0.5f)));
  Vec3 visibility = mix(Vec3(height), reached, min(frame.exponents.w, 1.0f));
  return mix(Vec3(frame.weights.w), one, visibility);
}

// Returns the environment's irradiance over pi on a surface with that normal; 1 for a white environment.
FUNCTION Vec3 environment_light(Vec3 n) {
  if (white_surroundings) return Vec3(1.0f);
  Vec3 sum = 0.28209479f * Vec3(frame.environment[0]);
  sum += 0.48860251f * (n.y * Vec3(frame.environment[1]) + n.z * Vec3(frame.environment[2]) + n.x * Vec3(frame.environment[3]));
  sum += 1.09254843f * (n.x * n.y * Vec3(frame.environment[4]) + n.y * n.z * Vec3(frame.environment[5]) +
                        n.x * n.z * Vec3(frame.environment[7]));
  sum += 0.31539157f * (3.0f * n.z * n.z - 1.0f) * Vec3(frame.environment[6]);
  sum += 0.54627422f * (n.x * n.x - n.y * n.y) * Vec3(frame.environment[8]);
  return max(sum, 0.0f);
}

FUNCTION FibreView view_of(Fibre fibre) {
  FibreView view;
  view.path = exit_path_length(fibre.height, dot(fibre.normal, fibre.to_camera));
  view.strands = strands_crossed(fibre.above, view.path, fibre.tangent, fibre.to_camera);
  view.widths = fibre.above / max(frame.counts.y, 1e-6f) * max(dot(fibre.tangent, fibre.normal), 0.15f);
  return view;
}
