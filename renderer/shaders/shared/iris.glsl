// The iris seen through the cornea, ray marched or flat, and the light that lids let through to it. All positions are
// in the eye's frame. Reads `eye` (an EyeEntry), eye_steps (steps of the march into the iris) and eye_lights (number of
// lights). The includer defines tissue_of_level and caustic_at.

// The rays that look at an eye.
struct EyeView {
  Vec3 along;  // direction, unit
  Real pixel;  // size of a pixel at the eye, radii
};

FUNCTION Vec3 in_eye_frame(Vec3 v) {
  return Vec3(dot(Vec3(eye.right), v), dot(Vec3(eye.up), v), dot(Vec3(eye.forward), v));
}
FUNCTION Vec3 out_of_eye_frame(Vec3 v) {
  return Vec3(eye.right) * v.x + Vec3(eye.up) * v.y + Vec3(eye.forward) * v.z;
}

// Returns the light that arrives at a position of the eye.
FUNCTION Arriving light_on_eye(int i, Vec3 position) {
  Vec3 in_world = Vec3(eye.position) + out_of_eye_frame(position) * eye.right.w;
  Arriving light = light_at(Index(i), in_world);
  light.to_light = in_eye_frame(light.to_light);
  return light;
}

// Returns the angle from a direction to the edge of the lids, radians; above 0 where the lids are open.
FUNCTION Real lid_opening(Vec3 direction) {
  if (eye.lid_right.w == 0.0f) return Real(10.0f);
  Real across = dot(Vec3(eye.lid_right), direction), up = dot(Vec3(eye.lid_up), direction);
  Real forward = dot(Vec3(eye.lid_facing), direction);
  Real x = atan2(across, forward) * (1.0f / eye.lid_right.w);
  Real y = atan2(up, sqrt(across * across + forward * forward));
  Real narrowing = 1.0f - x * x;
  return min(eye.lid_up.w * narrowing - y, y + eye.lid_facing.w * narrowing);
}

// Returns the share of the light from a direction that gets past the lids to a position under them.
FUNCTION Real lid_visibility(Vec3 position, Vec3 to_light) {
  if (eye.lid_right.w == 0.0f) return Real(1.0f);
  Real along = dot(position, to_light), apart = float(lid_radius) * float(lid_radius) - dot(position, position);
  Real path = sqrt(max(along * along + apart, 0.0f)) - along;
  Real share = smoothstep(-0.10f, 0.12f, lid_opening(unit_or_zero(position + to_light * path)));
  return select(apart <= 0.0f, 1.0f, share);
}

FUNCTION Real sky_visibility(Vec3 position) {
  return mix(0.22f, 1.0f, smoothstep(-0.05f, 0.55f, lid_opening(unit_or_zero(position))));
}

// Returns the refracted direction. There is no total reflection, because the index inside is at least 1.
FUNCTION Vec3 refracted(Vec3 along, Vec3 normal) {
  float eta = 1.0f / eye.position.w;
  Real cosine = clamp(-dot(along, normal), 0.0f, 1.0f);
  return along * eta + (eta * cosine - sqrt(max(1.0f - eta * eta * (1.0f - cosine * cosine), 0.0f))) * normal;
}

// Reads the tissue map (renderer/eye/iris_map.h). `pixel_rows`: rows of the map that a pixel covers.
FUNCTION Vec4 tissue_texel(Real around, Real along, Real pixel_rows) {
  float last = float(iris_map_levels - 1);
  Real lod = clamp(log2(max(pixel_rows, 1.0f)), 0.0f, last), finer = floor(lod);
  Vec4 fine = tissue_of_level(finer, around, along);
  if (!any_lane(lod > 0.0f)) return fine;
  return mix(fine, tissue_of_level(min(finer + 1.0f, last), around, along), lod - finer);
}

// Returns the angle around the axis in turns, relative to the rotation of the fibres.
FUNCTION Real angle_coordinate(Real x, Real y) { return atan2(y, x) * 0.15915494f + eye.inner.w; }

FUNCTION Vec4 iris_tissue(EyeView view, Vec2 at, Real edge) {
  Real ring_width = max(eye.up.w - edge, 0.02f);
  Real along = clamp((length(at) - edge) / ring_width, 0.0f, 1.0f);
  return tissue_texel(angle_coordinate(at.x, at.y), along, view.pixel * float(iris_map_height) / ring_width);
}

// Returns the position on one axis of a caustic map, in texels.
FUNCTION Real caustic_coordinate(Real turned) {
  float texels = float(caustic_texels);
  return clamp((turned * (0.5f / eye.up.w) + 0.5f) * texels - 0.5f, 0.0f, texels - 1.0f);
}

// Reads a caustic map bilinearly; `texel` is the upper left one of four texels. `above`: 0 for the angle's map, 1 for
// that of the next angle.
FUNCTION Real caustic_of_angle(Real texel, int above, Real px, Real py) {
  int first = above * caustic_texels * caustic_texels, below = first + caustic_texels;
  return mix(mix(caustic_at(texel, first), caustic_at(texel, first + 1), px),
             mix(caustic_at(texel, below), caustic_at(texel, below + 1), px), py);
}

// Returns the irradiance on the iris at a position, over that of a surface that faces the light.
FUNCTION Real caustic(Vec2 at, Vec3 to_light) {
  float last_angle = float(caustic_angles - 1), texels = float(caustic_texels);
  Real angle = acos(clamp(to_light.z, -1.0f, 1.0f)) * (last_angle / float(caustic_reach));
  Real scale = 1.0f / sqrt(max(to_light.x * to_light.x + to_light.y * to_light.y, 1e-12f));
  Real from_x = to_light.x * scale, from_y = to_light.y * scale;
  Real x = caustic_coordinate(at.x * from_x + at.y * from_y), y = caustic_coordinate(from_x * at.y - from_y * at.x);
  Real left = min(floor(x), texels - 2.0f), top = min(floor(y), texels - 2.0f);
  Real lower_map = clamp(floor(angle), 0.0f, last_angle - 1.0f);
  Real texel = ((eye.pupil.w + lower_map) * texels + top) * texels + left;
  Real px = x - left, py = y - top;
  Real share = mix(caustic_of_angle(texel, 0, px, py), caustic_of_angle(texel, 1, px, py), angle - lower_map);
  return select(angle < last_angle, share, 0.0f);
}

// Returns the distance from the axis to the pupil's edge in the direction of a position on the iris.
FUNCTION Real pupil_edge(Vec2 at) {
  float width = max(eye.pupil.x * eye.up.w, 1e-4f), height = max(eye.pupil.y * eye.up.w, 1e-4f);
  if (eye.pupil.z < 0.5f) return Real(width);
  Vec2 direction = at * (1.0f / sqrt(max(at.x * at.x + at.y * at.y, 1e-12f)));
  Real a = abs(direction.x) * (1.0f / width), b = direction.y * direction.y * (1.0f / (height * height));
  Real almond = 2.0f / (a + sqrt(a * a + 4.0f * b));  // |x| / w + (y / h)^2 = 1
  return 0.5f * (almond + 1.0f / sqrt(a * a + b));    // mean with an ellipse
}

// Returns the phase function of tissue (Henyey and Greenstein), relative to its value for light that is scattered
// straight back.
FUNCTION Real scattered_by_tissue(Real cosine) {
  float g = 0.2f, turned = 1.0f + g;
  Real share = turned * turned / (1.0f + g * g - 2.0f * g * cosine);
  return share * sqrt(share);
}

struct IrisLight {
  Vec3 arriving[max_lights];  // irradiance on the iris
  Real rising[max_lights];    // cosine of the refracted light to the axis
  Real scattered[max_lights];
  Vec3 sky;
  Vec3 total;  // sum of all lights and the sky
};

FUNCTION IrisLight light_on_iris(Vec3 surface, Vec3 normal, Vec3 inside, Vec2 at) {
  IrisLight lights;
  lights.sky = Vec3(sky_visibility(surface) * frame.weights.x);
  lights.total = lights.sky;
  for (int i = 0; i < eye_lights; ++i) {
    Arriving light = light_on_eye(i, surface);
    lights.arriving[i] = light.radiance * (caustic(at, light.to_light) * lid_visibility(surface, light.to_light));
    Vec3 facing = select(dot(light.to_light, normal) > 0.0f, normal, light.to_light);
    Vec3 direction = refracted(-light.to_light, facing);
    lights.rising[i] = max(-direction.z, 0.15f);
    lights.scattered[i] = scattered_by_tissue(-dot(direction, inside));
    lights.total += lights.arriving[i];
  }
  return lights;
}

FUNCTION Vec3 tissue_colour(Vec4 tissue) { return mix(Vec3(eye.iris), Vec3(eye.inner), tissue.z); }

// Shades a flat iris: all of its light comes from one position.
FUNCTION Vec3 flat_iris(EyeView view, Vec2 at, Vec3 arriving) {
  Real edge = pupil_edge(at), soft = max(view.pixel, 0.01f);
  Vec4 tissue = iris_tissue(view, at, edge);
  return arriving * tissue_colour(tissue) * (tissue.x * 1.5f * smoothstep(-soft, soft, length(at) - edge));
}

// Returns the light that a step through tissue sends back by single scattering, relative to thick tissue: attenuated on
// the light's path to the step and inside it, and on the ray's path inside it. Steps of any size add up to 1.
FUNCTION Real single_scattering(Real above, Real thick, Real slant, Real rising) {
  Real over = 1.0f / rising;
  return exp(-above * over) * (1.0f - exp(-thick * (slant + over)));
}

// One step of a march through the iris.
struct IrisStep {
  Real below, above, thick;  // height of the tissue above the step, optical depth above it and in it
  Real slant;
};

FUNCTION Vec3 light_of_step(In(IrisLight) lights, IrisStep part, Vec4 tissue) {
  Vec3 light = lights.sky * single_scattering(part.above, part.thick, part.slant, 2.0f);
  for (int i = 0; i < eye_lights; ++i) {
    light +=
        lights.arriving[i] * (lights.scattered[i] * single_scattering(part.above, part.thick, part.slant, lights.rising[i]));
  }
  Vec3 colour = tissue_colour(tissue);
  return light * mix(colour, colour * colour, clamp(part.below, 0.0f, 1.0f)) * (tissue.x * 1.5f);
}

// Returns a step; `depth` of its middle and its thickness `share` are relative to the height of the relief.
FUNCTION IrisStep iris_step(Real relief, float depth, float share, Real slant) {
  float density = 7.0f;  // optical depth of the whole relief
  IrisStep part;
  part.below = relief - (1.0f - depth);
  part.slant = slant;
  part.thick = density * min(max(part.below + 0.5f * share, 0.0f), share);
  part.above = density * max(part.below - 0.5f * share, 0.0f);
  return part;
}

// Ray marches through the iris: subsurface texture mapping (Francois et al. 2006). The height map says where tissue is.
// Tissue scatters once; deeper tissue is darker and more saturated. Below it is the pigment.
FUNCTION Vec3 marched_iris(EyeView view, Vec2 top, Vec2 bottom, Real slant, In(IrisLight) lights) {
  float share = 1.0f / float(eye_steps);
  Vec3 sum = Vec3(0.0f);
  Real passed = Real(1.0f);
  for (int k = 0; k < eye_steps && any_lane(passed > 0.02f); ++k) {
    float depth = (float(k) + 0.5f) * share;
    Vec2 at = Vec2(mix(top.x, bottom.x, depth), mix(top.y, bottom.y, depth));
    Real edge = pupil_edge(at);
    Vec4 tissue = iris_tissue(view, at, edge);
    IrisStep part = iris_step(tissue.y, depth, share, slant);
    Real there = select(passed > 0.02f, smoothstep(-view.pixel, view.pixel, length(at) - edge), 0.0f);
    if (!any_lane(part.thick * there > 0.0f)) continue;
    sum += light_of_step(lights, part, tissue) * (passed * there);
    passed *= 1.0f - there * (1.0f - exp(-part.thick * slant));
  }
  Vec3 colour = Vec3(eye.iris);
  Real seen = smoothstep(-view.pixel, view.pixel, length(bottom) - pupil_edge(bottom));
  return sum + lights.total * colour * colour * (0.25f * passed * seen);
}

// Where the ray that enters the cornea at a position hits the plane of the iris.
struct BehindCornea {
  Vec3 inside;  // direction inside, unit
  Real over;    // path length over depth
  Vec2 bottom;
};

FUNCTION BehindCornea behind_cornea(EyeView view, Vec3 position, Vec3 normal) {
  BehindCornea behind;
  behind.inside = Vec3(0.0f, 0.0f, -1.0f);
  if (eye_steps > 0) behind.inside = refracted(view.along, normal);
  behind.over = 1.0f / max(-behind.inside.z, 0.05f);
  Real fallen = max(position.z - eye.cornea.z, 0.0f) * behind.over;
  behind.bottom = Vec2(position.x + behind.inside.x * fallen, position.y + behind.inside.y * fallen);
  return behind;
}

// Returns the light that comes through the cornea at a position on it.
FUNCTION Vec3 iris_light(EyeView view, Vec3 position, Vec3 normal) {
  float radius = eye.up.w;
  BehindCornea behind = behind_cornea(view, position, normal);
  Vec3 inside = behind.inside;
  Vec2 bottom = behind.bottom, top = bottom - Vec2(inside.x, inside.y) * (eye.cornea.w * behind.over);
  Real reach = length(bottom), wall = Real(0.0f);
  bottom = bottom * min(1.0f, radius / max(reach, 1e-6f));
  if (eye_steps > 0) wall = smoothstep(0.97f, 1.04f, reach * (1.0f / radius));  // side wall of the eye's chamber
  IrisLight lights = light_on_iris(position, normal, inside, bottom);
  Vec3 seen;
  if (eye_steps <= 1) {
    seen = flat_iris(view, bottom, lights.total);
  } else {
    seen = marched_iris(view, top, bottom, behind.over, lights);
  }
  Real ring = eye.iris.w * smoothstep(0.72f, 0.98f, length(bottom) * (1.0f / radius));
  return mix(seen * (1.0f - 0.92f * ring), Vec3(eye.iris) * (0.03f * sky_visibility(position)), wall);
}
