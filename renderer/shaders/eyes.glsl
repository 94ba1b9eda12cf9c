// The eyes of a frame. Include it after frame.glsl and shared/light.glsl. The includer defines eye_steps, the number of
// steps of a march into an iris. Layout std430; EyeBlock of renderer/eye/optics.h mirrors it.
#include "constants.glsl"
#include "dialect.glsl"
#include "shared/strand.glsl"
struct EyeEntry {
  vec4 right, up, forward;             // axes; w: radius, radius of the iris, z of the limbus
  vec4 position;                       // w: refraction
  vec4 cornea;                         // z of its centre, radius, z of the iris, height of the iris fibres
  vec4 iris, inner;                    // colours; w: strength of the limbal ring, rotation of the fibres in turns
  vec4 pupil;                          // semi-axes over the iris radius, 1 for a slit, first map of caustics
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

EyeEntry eye;  // the eye that is shaded; take_eye sets these three
vec3 eye_viewer;
int eye_lights;

// Returns the number of words of all levels before a level; each has a quarter of those of the last.
int first_word(int level) {
  int words = 4 * iris_map_width * iris_map_height;
  return (words - (words >> (2 * level))) / 3;
}

// Reads a level bilinearly at a position in [0, 1]^2; `around` wraps, `along` is clamped.
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

// Returns the caustic `beside` texels after a texel, which is an integer.
float caustic_at(float texel, int beside) { return caustics[int(texel) + beside]; }

#include "shared/iris.glsl"
#include "shared/eye.glsl"

// Selects the eye of the frame that is shaded, by the first `lights` of the frame's lights.
void take_eye(uint number, int lights) {
  eye = eyes[number];
  eye_viewer = in_eye_frame(frame.viewpoint.xyz - eye.position.xyz) / eye.right.w;
  eye_lights = lights;
}
