// The shadow of a model on the ground. Reads the same as grid_shadow.glsl; of the scene ground_height, ground_contact,
// ground_shadow, light_radius, is_directional and disc_tap; and the map of sky occlusion over the ground: sky_low,
// sky_cell, sky_size and the function sky_hidden_at.

// Reads the map bilinearly: share of the sky that is occluded, 0 outside of the map.
FUNCTION Real sky_hidden(Vec3 position) {
  if (sky_size.x == 0) return Real(0.0f);
  Real x = (position.x - sky_low.x) * (1.0f / sky_cell), y = (position.z - sky_low.y) * (1.0f / sky_cell);
  float width = float(sky_size.x), height = float(sky_size.y);
  Real left = clamp(floor(x), 0.0f, width - 2.0f), top = clamp(floor(y), 0.0f, height - 2.0f);
  Real across = clamp(x - left, 0.0f, 1.0f), down = clamp(y - top, 0.0f, 1.0f);
  Real at = mul_add(top, width, left);
  Real above = mix(sky_hidden_at(at, 0), sky_hidden_at(at, 1), across);
  Real below = mix(sky_hidden_at(at, sky_size.x), sky_hidden_at(at, sky_size.x + 1), across);
  Mask inside = both(both(x >= 0.0f, y >= 0.0f), both(x <= width - 1.0f, y <= height - 1.0f));
  return select(inside, mix(above, below, down), 0.0f);
}

// Where the path from a position to a light enters the grid, if it does: what it crosses from there on is known.
struct GridEntry {
  Vec3 position;
  Mask there;
};

// The range of distances at which a path lies between planes.
struct RayInterval {
  Real begin, end;
};

FUNCTION RayInterval between_planes(RayInterval ray, Real at, Real step, float low, float high) {
  Real over = 1.0f / select(abs(step) > 1e-6f, step, 1e-6f);
  Real first = (Real(low) - at) * over, last = (Real(high) - at) * over;
  ray.begin = max(ray.begin, min(first, last));
  ray.end = min(ray.end, max(first, last));
  return ray;
}

FUNCTION GridEntry grid_entry(Vec3 from, Vec3 ray) {
  RayInterval inside;
  inside.begin = Real(0.0f);
  inside.end = Real(1e9f);
  inside = between_planes(inside, from.x, ray.x, grid_low.x, grid_low.x + grid_cell * float(grid_size.x));
  inside = between_planes(inside, from.y, ray.y, grid_low.y, grid_low.y + grid_cell * float(grid_size.y));
  inside = between_planes(inside, from.z, ray.z, grid_low.z, grid_low.z + grid_cell * float(grid_size.z));
  GridEntry entry;
  entry.position = from + ray * inside.begin;
  entry.there = inside.begin < inside.end;
  return entry;
}

// Returns the share of a light that reaches a position on the ground past the body and strands that stop `stopped`.
FUNCTION Real light_visibility(Index light, Vec3 position, Vec3 to_light, Vec3 stopped) {
  GridEntry entry = grid_entry(position, to_light);
  if (!any_lane(entry.there)) return Real(1.0f);
  Crossing crossed = crossed_at(light, grid_cells(entry.position));
  return select(entry.there, luminance(transmittance_of(crossed, stopped)), 1.0f);
}

// Returns the same for a light with a size, by samples of its disc. Its radius is in sizes; that of a directional light
// is the tangent of half its angle.
FUNCTION Real area_light_visibility(Index light, Vec3 position, Vec3 to_light, Vec3 stopped) {
  float radius = light_radius(light);
  if (!(radius > 0.0f)) return light_visibility(light, position, to_light, stopped);
  Real spread = Real(radius);
  if (!is_directional(light)) spread = spread / max(length(Vec3(frame.lights[light].position) - position), 1e-3f);
  Vec3 across = unit(cross(to_light, Vec3(1.0f, 0.0f, 0.0f))), up = cross(across, to_light);  // the light is above
  Real sum = Real(0.0f);
  for (int tap = 0; tap < ground_light_taps; ++tap) {
    Vec3 off = disc_tap(tap).x * across + disc_tap(tap).y * up;
    sum += light_visibility(light, position, unit(to_light + spread * off), stopped);
  }
  return sum * (1.0f / float(ground_light_taps));
}

// Returns the share of the ground's light that is occluded at a position, summed as the tracer does.
FUNCTION Real ground_occlusion(Vec3 position) {
  Vec3 crossed = Vec3(frame.ramp_root) * Vec3(frame.colour_above[0]), stopped = stopped_by_strand(crossed, 1.0f);
  Real whole = Real(frame.weights.x), missing = frame.weights.x * ground_contact * sky_hidden(position);
  for (Index i = 0; i < light_count; ++i) {
    Arriving light = light_at(i, position);
    Real arrives = frame.weights.y * max(light.to_light.y, 0.0f) * luminance(light.radiance);
    whole += arrives;
    if (!any_lane(arrives > 0.0f)) continue;
    missing += arrives * ground_shadow * (1.0f - area_light_visibility(i, position, light.to_light, stopped));
  }
  return clamp(missing / max(whole, 1e-6f), 0.0f, 1.0f);
}

// Returns how dark the ground is where rays from the camera hit it; the shadow fades out away from the middle.
FUNCTION Real ground_darkness(Vec3 ray) {
  float faded_from = 1.0f, faded_to = 3.5f;  // sizes from the middle
  Real distance = (ground_height - camera_position.y) / min(ray.y, -1e-9f);
  Vec3 position = Vec3(camera_position) + ray * distance;
  Real from_middle = length(Vec3(position.x, Real(0.0f), position.z));
  Mask there = both(ray.y < -1e-9f, from_middle < faded_to);
  if (!any_lane(there)) return Real(0.0f);
  return select(there, ground_occlusion(position) * (1.0f - smoothstep(faded_from, faded_to, from_middle)), 0.0f);
}
