// Light on fur: what arrives, and what gets through. Reads the block `frame`; far_lights and white_surroundings are the
// includer's.

// What lies between a place and a light: how many strands, and the optical depth of the body.
struct Crossing {
  Real strands, body;
};

FUNCTION Arriving light_at(Index i, Vec3 place) {
  LightBlock light = frame.lights[i];
  Arriving arriving;
  arriving.to_light = -Vec3(light.direction);
  arriving.radiance = Vec3(light.radiance);
  if (far_lights) return arriving;
  Vec3 apart = Vec3(light.position) - place;
  Real square = max(dot(apart, apart), float(min_light_square));
  if (light.direction.w > 0.5f) {  // it stands somewhere
    arriving.to_light = apart * (1.0f / sqrt(square));
    arriving.radiance = arriving.radiance * min(1.0f / square, float(max_light_falloff));
  }
  float edge = light.position.w, width = light.radiance.w - edge;
  Real inside = -dot(arriving.to_light, Vec3(light.direction));
  arriving.radiance = arriving.radiance * clamp((inside - edge) / max(width, 1e-6f), 0.0f, 1.0f);
  return arriving;
}

// Share of the light that a strand of that colour stops, by `part` of its thickness. Light that passes pale fur keeps its
// colour and much of its strength: t_c = t^(1 - f_c) (science.md 4), with t = exp(-2) past a black strand.
FUNCTION Vec3 stopped_by_strand(Vec3 colour, float part) {
  float black = -2.0f * 1.442695f * part * frame.exponents.w;
  return Vec3(1.0f) - exp2(black * (Vec3(1.0f) - 0.82f * sqrt(clamp(colour, 0.0f, 1.0f))));
}

// Share of the light from all around that gets to a height: g of GPU fur eq 1, with s where nothing better is known.
// Where the self-shadow knows the fur above, it takes the place of s; both together would darken the same fur twice.
// From a direction at the angle x to the normal it crosses `above` tan x strands and is weighed by cos x. The mean of
// exp(-a tan x) over the half sphere falls by pi/2 a at first and as 2 over the square of a at last; this is within .01.
// `stopped` is by .6 of a strand's thickness.
FUNCTION Vec3 ambient_share(Real height, Real above, Vec3 stopped) {
  Vec3 a = above * stopped, one = Vec3(1.0f);
  Vec3 reached = (one + a) / (one + a * (Vec3(2.5707963f) + a * (Vec3(1.21f) + a * 0.5f)));
  Vec3 open = mix(Vec3(height), reached, min(frame.exponents.w, 1.0f));
  return mix(Vec3(frame.weights.w), one, open);
}

// Light from all around on a surface with that normal; 1 for a white surrounding.
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
  view.way = way_out(fibre.height, dot(fibre.normal, fibre.to_camera));
  view.strands = strands_crossed(fibre.above, view.way, fibre.tangent, fibre.to_camera);
  view.widths = fibre.above / max(frame.counts.y, 1e-6f) * max(dot(fibre.tangent, fibre.normal), 0.15f);
  return view;
}
