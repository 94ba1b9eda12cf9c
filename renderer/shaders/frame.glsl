#include "constants.glsl"
#include "luminance.glsl"

// What every pass of a frame knows. Layout std140; renderer/upload/blocks.h mirrors it.
struct LightBlock {
  vec4 direction;  // where the light goes, unit; w is 0, or 1 for a light at a position
  vec4 position;   // w: cosine of a spot's cone, -2 for other lights
  vec4 radiance;   // w: cosine at which a spot begins to fade
};

layout(std140, binding = frame_binding) uniform FrameBlock {
  mat4 world_to_clip;
  vec4 viewpoint;          // w: size of a pixel at distance 1
  vec4 half_picture; // pixels to the right and down that a unit of clip space is
  vec4 weights;      // ambient, diffuse, specular, ambient floor
  vec4 exponents;    // diffuse, specular, back attenuation, self-shadow (0 when off)
  vec4 skin;         // rgb; w: 1 where the fur takes the model's colours
  vec4 counts;       // shells, strands met on a strand's width across upright ones, lights, root share
  vec4 tile;         // 1 / side, size of a pixel that reads the finest texels, lean curve (0 arc, 1 root), largest ramp lightness
  vec4 depth_scale[slice_levels];  // for each level: along the stack, at 60, 30 and 75 degrees
  vec4 depth_above[slice_count / 4];  // four each: strands over each slice that a ray at 45 degrees crosses
  vec4 colour_above[slice_count];  // of the fur over each slice, over the colour there
  vec4 ramp_root;    // colour at the root
  LightBlock lights[max_lights];
  vec4 environment[9];  // irradiance over pi as spherical harmonics
} frame;
