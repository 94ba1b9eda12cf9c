// Eyes, each in its own frame: the ball has radius 1, +Z is the axis. renderer/eye/eye_block.h mirrors it.
#include "constants.glsl"
struct Eye {
  vec4 right;       // unit, in the model's coordinates; w: radius, sizes
  vec4 up;          // w: radius of the iris
  vec4 forward;     // where it looks; w: z of the limbus
  vec4 position;    // w: refractive index
  vec4 cornea;      // z of its centre, its radius, z of the iris, relief of the iris
  vec4 iris;        // colour; w: limbal ring
  vec4 inner;       // colour by the pupil; w: turn of the fibres, turns
  vec4 pupil;       // half width, half height (over the iris), 1 for a slit, first shell of its caustics
  vec4 sclera;      // colour; w: wetness
  vec4 lid_right;   // in the eye's frame; w: opening to a corner, radians, 0 without lids
  vec4 lid_up;      // w: opening to the upper lid
  vec4 lid_facing;  // w: opening to the lower lid
  vec4 lid;         // colour
};

layout(std140, binding = eye_binding) uniform EyeBlock {
  vec4 surroundings;  // colour that the cornea reflects, linear
  Eye eyes[max_eyes];
};

const float lid_radius = 1.07;
