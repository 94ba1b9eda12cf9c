// Eyes in front of the skin: renderer/raster/eyes-inl.h.
const bool white_surroundings = false;
#include "../../shaders/shared/strand.glsl"
#include "../../shaders/shared/light.glsl"
#include "../../shaders/eyes.glsl"

// For each pixel: the bits of 1 / distance of the nearest eye (0 for none), and the number of that eye.
layout(std430, binding = eye_pixels_storage) buffer EyePixels { uint eye_pixels[]; };

EyeHit hit_of_pixel(vec2 pixel) { return intersect_eye(in_eye_frame(ray_through(pixel)), frame.viewpoint.w); }
