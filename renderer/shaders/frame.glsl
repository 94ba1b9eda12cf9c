#include "constants.glsl"
#include "luminance.glsl"

// Uniforms of all passes of a frame. Layout std140; renderer/upload/blocks.h mirrors it.
struct LightBlock {
  vec4 direction;  // direction of travel, unit; w: 0, or 1 for a light at a position
  vec4 position;   // w: cosine at which a spot or area light has faded out, -2 for other lights
  vec4 radiance;   // w: cosine at which a spot or area light begins to fade
};

layout(std140, binding = frame_binding) uniform FrameBlock {
  mat4 world_to_clip;
  vec4 viewpoint;          // w: size of a pixel at distance 1
  vec4 half_picture; // pixels to the right and down for a unit of clip space
  vec4 weights;      // ambient, diffuse, specular, ambient floor
  vec4 exponents;    // diffuse, specular, back attenuation, self-shadow (0 when off)
  vec4 skin;         // colour; w: 1 if the fur takes the model's colours
  vec4 counts;       // shells, mean strands that a horizontal ray crosses per strand width, lights, root share
  vec4 tile;         // 1 / side, pixel size that reads the finest texels, lean curve (0 arc, 1 root), largest ramp lightness
  vec4 depth_scale[slice_levels];  // for each level: along the stack, at 60, 30 and 75 degrees
  vec4 depth_above[slice_count / 4];  // four slices each: strands above the slice that a ray at 45 degrees crosses
  vec4 colour_above[slice_count];  // mean colour of the fur above each slice, over the colour there
  vec4 ramp_root;    // colour at the root
  LightBlock lights[max_lights];
  vec4 environment[9];  // irradiance over pi, as spherical harmonics
} frame;
