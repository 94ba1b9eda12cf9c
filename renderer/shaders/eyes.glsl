// The eyes of a frame. After frame.glsl and shared/light.glsl; eye_steps, how many a march into an iris takes, is the
// includer's. Layout std430; EyeBlock of renderer/eye/optics.h mirrors it.
#include "constants.glsl"
#include "dialect.glsl"
#include "shared/strand.glsl"
struct EyeEntry {
  vec4 right, up, forward;             // axes; w: radius, radius of the iris, z of the limbus
  vec4 position;                       // w: refraction
  vec4 cornea;                         // z of its centre, radius, z of the iris, height of the fibres on that
  vec4 iris, inner;                    // colours; w: limbal ring, turns that the fibres are turned by
  vec4 pupil;                          // semi-axes over the iris, 1 for a slit, first map of caustics
  vec4 sclera;                         // colour; w: wetness
  vec4 lid_right, lid_up, lid_facing;  // axes; w: half angles of the opening, sideways (0 without lids), up, down
  vec4 lid;                            // colour
};

layout(std430, binding = raster_eyes_storage) readonly buffer EyeBlock {
  vec4 surroundings;
  EyeEntry eyes[max_eyes];
};
layout(std430, binding = raster_tissue_storage) readonly buffer Tissues { uint tissue_words[]; };  // TissueLevels
layout(std430, binding = raster_caustics_storage) readonly buffer Caustics { float caustics[]; };

EyeEntry eye;  // that is shaded; take_eye sets these three
vec3 eye_viewer;
int eye_lights;

// Words of the levels before one: each has a quarter of those of the last.
int first_word(int level) {
  int words = 4 * iris_map_width * iris_map_height;
  return (words - (words >> (2 * level))) / 3;
}

// Even between the four texels about a place in [0, 1]; the sides of a row meet.
vec4 tissue_of_level(float number, float around, float along) {
  int level = int(number), first = first_word(level);
  int width = iris_map_width >> level, height = iris_map_height >> level;
  vec2 at = vec2(around * float(width) - 0.5, clamp(along * float(height) - 0.5, 0.0, float(height - 1)));
  ivec2 corner = ivec2(floor(at));
  vec2 share = at - vec2(corner);
  vec4 sum = vec4(0.0);
  for (int k = 0; k < 4; ++k) {
    int column = (corner.x + (k & 1)) & (width - 1), row = min(corner.y + (k >> 1), height - 1);
    float weight = ((k & 1) != 0 ? share.x : 1.0 - share.x) * ((k & 2) != 0 ? share.y : 1.0 - share.y);
    sum += weight * unpackUnorm4x8(tissue_words[first + row * width + column]);
  }
  return sum;
}

// The one that lies so many after a whole number.
float caustic_at(float texel, int beside) { return caustics[int(texel) + beside]; }

#include "shared/iris.glsl"
#include "shared/eye.glsl"

// Makes an eye of the frame the one that is shaded, by so many of the frame's lights.
void take_eye(uint number, int lights) {
  eye = eyes[number];
  eye_viewer = in_eye_frame(frame.viewpoint.xyz - eye.position.xyz) / eye.right.w;
  eye_lights = lights;
}
