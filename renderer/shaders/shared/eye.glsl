// An eye: where rays hit its ball, cornea and lids, and the light that they send back. All positions are in the eye's
// frame, in radii. Include it after iris.glsl, whose names it reads. The includer also defines eye_viewer, the camera
// in the eye's frame, and surroundings, the colour around the head.

// Returns the colour of the white of the eye, which vessels redden away from the iris.
FUNCTION Vec3 sclera_colour(EyeView view, Vec3 position) {
  Real back = acos(clamp(position.z, -1.0f, 1.0f)) - asin(clamp(eye.up.w, 0.0f, 1.0f));
  Vec4 tissue = tissue_texel(angle_coordinate(position.x, position.y), clamp(back * (1.0f / 1.2f), 0.0f, 1.0f),
                             view.pixel * (float(iris_map_height) / 1.2f));
  Real lid = 1.0f - smoothstep(0.0f, 0.45f, lid_opening(unit_or_zero(position)));
  Real red = clamp(0.75f * lid + 0.5f * smoothstep(0.15f, 1.0f, back), 0.0f, 1.0f);
  Vec3 white = Vec3(1.0f);
  Vec3 colour = Vec3(eye.sclera) * mix(white, Vec3(0.80f, 0.42f, 0.36f), 0.6f * red);
  colour *= mix(white, Vec3(0.72f, 0.25f, 0.20f), 0.65f * tissue.w * (0.35f + 0.65f * red));
  return colour * (1.0f - 0.9f * eye.iris.w * (1.0f - smoothstep(0.0f, 0.16f, back)));
}

FUNCTION Real wrapped_light(Real cosine, float wrap) { return max((cosine + wrap) * (1.0f / (1.0f + wrap)), 0.0f); }

FUNCTION Vec3 sclera_light(EyeView view, Vec3 position, Vec3 normal) {
  Vec3 sum = Vec3(sky_visibility(position) * frame.weights.x);
  for (int i = 0; i < eye_lights; ++i) {
    Arriving light = light_on_eye(i, position);
    Real cosine = dot(normal, light.to_light);
    Vec3 wrapped = Vec3(wrapped_light(cosine, 0.45f), wrapped_light(cosine, 0.28f), wrapped_light(cosine, 0.22f));
    sum += light.radiance * wrapped * lid_visibility(position, light.to_light);
  }
  return sclera_colour(view, position) * sum;
}

// Returns the environment's light along a reflected ray: a soft sky, a darker ground, and fur beside the eye.
FUNCTION Vec3 surroundings_along(Vec3 direction, Vec3 position) {
  Real height = eye.right.y * direction.x + eye.up.y * direction.y + eye.forward.y * direction.z;
  Vec3 facing = eye.lid_right.w == 0.0f ? Vec3(0.0f, 0.0f, 1.0f) : Vec3(eye.lid_facing);
  Real share = mix(0.30f, 1.15f, smoothstep(-0.25f, 0.75f, height)) *
               mix(0.08f, 1.0f, smoothstep(-0.15f, 0.55f, dot(direction, facing)));
  return Vec3(surroundings) * (share * lid_visibility(position, direction));
}

// Returns the Fresnel reflectance of unpolarised light, as in renderer/eye/optics.cpp.
FUNCTION Real eye_reflectance(Real cosine) {
  float index = eye.position.w, square = index * index;
  Real c = clamp(cosine, 0.0f, 1.0f), inside = sqrt(max(square - 1.0f + c * c, 0.0f)), sum = inside + c;
  Real across = (c - inside) / max(sum, 1e-6f), along = (square * c - inside) / max(square * c + inside, 1e-6f);
  return select(sum <= 1e-6f, 0.0f, 0.5f * (across * across + along * along));
}

// Returns the reflections in the tear film. Every light is a soft disc, whose size depends on wetness and whose energy
// does not.
FUNCTION Vec3 light_in_tear_film(EyeView view, Vec3 position, Vec3 normal) {
  float wetness = eye.sclera.w;
  float disc = 0.5f + wetness * (0.11f - 0.5f);  // radians
  float gain = 1.0f / (sin(disc) * sin(disc));
  Real cosine = dot(view.along, normal);
  Vec3 direction = view.along - 2.0f * min(cosine, 0.0f) * normal;
  Vec3 sum = surroundings_along(direction, position);
  for (int i = 0; i < eye_lights; ++i) {
    Arriving light = light_on_eye(i, position);
    Real off = acos(clamp(dot(direction, light.to_light), -1.0f, 1.0f));
    Real shown = 1.0f - smoothstep(0.85f * disc, 1.15f * disc, off);
    if (any_lane(shown > 0.0f)) sum += light.radiance * (gain * shown * lid_visibility(position, light.to_light));
  }
  return sum * (eye_reflectance(-cosine) * (0.35f + 0.65f * wetness));
}

// Returns how close a position is to the moist edge of the lids: 1 at the edge.
FUNCTION Real lid_margin(Vec3 normal) { return 1.0f - smoothstep(0.02f, 0.14f, -lid_opening(normal)); }

FUNCTION Vec3 lid_colour(Real margin) {
  Vec3 lid = Vec3(eye.lid);
  return mix(lid, lid * Vec3(0.7f, 0.55f, 0.55f), margin);
}

FUNCTION Vec3 lid_light(EyeView view, Vec3 position) {
  Vec3 normal = unit_or_zero(position);
  Real margin = lid_margin(normal);
  Vec3 colour = lid_colour(margin);
  Vec3 sum = colour * frame.weights.x;
  for (int i = 0; i < eye_lights; ++i) {
    Arriving light = light_on_eye(i, position);
    Vec3 middle = unit_or_zero(light.to_light - view.along);
    Real gloss = mix(0.03f, 0.25f, margin) * pow(clamp(dot(normal, middle), 1e-12f, 1.0f), mix(10.0f, 40.0f, margin));
    sum += light.radiance * (colour + Vec3(gloss)) * max(dot(normal, light.to_light), 0.0f);
  }
  return sum;
}

// Returns 1 on the cornea and 0 on the white, with a soft edge.
FUNCTION Real cornea_share(EyeView view, Vec3 position) {
  float radius = eye.up.w;
  Real soft = max(0.04f * radius, view.pixel);
  Real off = sqrt(position.x * position.x + position.y * position.y);
  return select(position.z > 0.0f, 1.0f - smoothstep(radius - soft, radius + soft, off), 0.0f);
}

// Returns the normal of ball and cornea, bent to be front-facing where it is not.
FUNCTION Vec3 eyeball_normal(EyeView view, Vec3 position, Real cornea) {
  Vec3 bulged = unit_or_zero(position - Vec3(0.0f, 0.0f, eye.cornea.x));
  Vec3 normal = unit_or_zero(mix(unit_or_zero(position), bulged, cornea));
  Real cosine = dot(normal, view.along);
  return select(cosine > -1e-3f, unit_or_zero(normal - view.along * (cosine + 1e-3f)), normal);
}

FUNCTION Vec3 eyeball_light(EyeView view, Vec3 position) {
  Real cornea = cornea_share(view, position);
  Vec3 normal = eyeball_normal(view, position, cornea);
  Vec3 seen = Vec3(0.0f);
  if (any_lane(cornea < 1.0f)) seen = sclera_light(view, position, normal);
  if (any_lane(cornea > 0.0f)) seen = mix(seen, iris_light(view, position, normal), cornea);
  Real transmitted = 1.0f - eye_reflectance(-dot(view.along, normal));
  Real opening = lid_opening(unit_or_zero(position));
  Real shaded = mix(0.30f, 1.0f, smoothstep(0.0f, 0.30f, opening));  // shadow of lids and lashes
  return shaded * (seen * transmitted + light_in_tear_film(view, position, normal));
}

// Where rays enter a sphere.
struct BallHit {
  Vec3 position;
  Real covered;  // share of the pixel, [0, 1]; the edge is one pixel wide
};

// Intersects a sphere with its centre on the axis. It starts at `close_by`, a position on the ray near the eye, to keep
// precision far from the eye. Where the ray misses by less than a pixel, the hit is on the silhouette.
FUNCTION BallHit enter_ball(Vec3 close_by, Vec3 along, Real pixel, float centre, float radius) {
  Vec3 middle = Vec3(0.0f, 0.0f, centre), off = close_by - middle, nearest = off - along * dot(off, along);
  Real square = dot(nearest, nearest), inner = radius * radius - square;
  Vec3 entered = nearest - along * sqrt(max(inner, 0.0f));
  Vec3 beside = nearest * (radius / sqrt(max(square, 1e-12f)));
  BallHit ball;
  ball.position = select(inner > 0.0f, entered, beside) + middle;
  ball.covered = clamp((radius - sqrt(square)) / pixel + 0.5f, 0.0f, 1.0f);
  return ball;
}

// The hit of rays on an eye.
struct EyeHit {
  Mask there;
  Vec3 ball, lid;      // positions
  Vec3 along;          // direction of the ray, unit
  Real pixel;          // size of a pixel at the eye, radii
  Real ball_covered, covered;  // shares of the pixel that the ball covers, and the eye with its lids
  Real shut;           // share of that which lids cover
  Vec3 nearest;        // the nearer one of the two positions
};

// Returns the distance at which a ray has passed the nearer of two opposite sides of a box.
FUNCTION Real distance_to_sides(Real along, float from, float high, float low) {
  Real to = select(along > 0.0f, low - from, high - from);
  return select(abs(along) > 1e-9f, to / along, -1e30f);
}

// Returns the distance at which rays enter the eye's bounding box, where the shader takes the size of a pixel.
FUNCTION Real distance_to_box(Vec3 along) {
  float side = 1.02f * float(lid_radius), top = 1.02f * max(float(lid_radius), eye.cornea.x + eye.cornea.y);
  return max(distance_to_sides(along.x, eye_viewer.x, side, -side),
             max(distance_to_sides(along.y, eye_viewer.y, side, -side), distance_to_sides(along.z, eye_viewer.z, top, -side)));
}

// Intersects an eye. `direction`: in the eye's frame, of any length; `pixel_angle`: angle of a pixel.
FUNCTION EyeHit intersect_eye(Vec3 direction, float pixel_angle) {
  EyeHit hit;
  hit.along = unit(direction);
  Vec3 from = Vec3(eye_viewer), close_by = from - hit.along * dot(from, hit.along);
  Real middle = length(close_by - from), before = distance_to_box(hit.along);
  hit.pixel = max(pixel_angle * clamp(before, middle - 2.0f, middle), 1e-6f);
  BallHit ball = enter_ball(close_by, hit.along, hit.pixel, 0.0f, 1.0f);
  BallHit dome = enter_ball(close_by, hit.along, hit.pixel, eye.cornea.x, eye.cornea.y);
  BallHit lid = enter_ball(close_by, hit.along, hit.pixel, 0.0f, float(lid_radius));
  Mask over = both(dome.covered > 0.0f,
                   either(ball.covered <= 0.0f, dot(dome.position - ball.position, hit.along) < 0.0f));
  hit.ball = select(over, dome.position, ball.position);
  hit.lid = lid.position;
  hit.ball_covered = max(ball.covered, dome.covered);
  hit.shut = Real(0.0f);
  if (eye.lid_right.w != 0.0f && length(eye_viewer) > float(lid_radius)) {
    hit.shut = 1.0f - smoothstep(-0.5f * hit.pixel, 0.5f * hit.pixel, lid_opening(unit_or_zero(lid.position)));
  }
  hit.covered = mix(hit.ball_covered, lid.covered, hit.shut);
  hit.nearest = select(hit.shut > 0.5f, hit.lid, hit.ball);
  // Ignores eyes behind or around the camera.
  hit.there = both(hit.covered > 0.0f, dot(hit.nearest - from, hit.along) > 0.0f);
  return hit;
}

FUNCTION EyeView eye_view(EyeHit hit) {
  EyeView view;
  view.along = hit.along;
  view.pixel = hit.pixel;
  return view;
}

// Returns the light of the hit, clamped because values beyond half float would blend badly on the GPU.
FUNCTION Vec3 eye_light(EyeHit hit) {
  EyeView view = eye_view(hit);
  Mask ball = both(hit.there, both(hit.shut < 1.0f, hit.ball_covered > 0.0f)), lid = both(hit.there, hit.shut > 0.0f);
  Vec3 light = Vec3(0.0f);
  if (any_lane(ball)) light = select(ball, eyeball_light(view, hit.ball), light);
  if (any_lane(lid)) light = select(lid, mix(light, lid_light(view, hit.lid), hit.shut), light);
  return clamp(light, 0.0f, 6e4f);
}

// The surface at a hit.
struct EyeSurface {
  Vec3 position, normal, albedo;  // in world space
};

FUNCTION EyeSurface eye_surface(EyeHit hit) {
  EyeView view = eye_view(hit);
  Real cornea = cornea_share(view, hit.ball);
  Vec3 ball_normal = eyeball_normal(view, hit.ball, cornea), lid_normal = unit_or_zero(hit.lid);
  Vec2 at = behind_cornea(view, hit.ball, ball_normal).bottom;
  Real edge = pupil_edge(at), there = smoothstep(-hit.pixel, hit.pixel, length(at) - edge);
  Vec4 tissue = iris_tissue(view, at, edge);
  Vec3 ball = mix(sclera_colour(view, hit.ball), tissue_colour(tissue) * (there * tissue.x), cornea);
  EyeSurface surface;
  surface.position = Vec3(eye.position) + out_of_eye_frame(hit.nearest) * eye.right.w;
  surface.normal = out_of_eye_frame(select(hit.shut > 0.5f, lid_normal, ball_normal));
  surface.albedo = mix(ball, lid_colour(lid_margin(lid_normal)), hit.shut);
  return surface;
}
