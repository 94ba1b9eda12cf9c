// Rec. 709 luminance, as base/colour_space.h.
float luminance(vec3 linear) { return dot(linear, vec3(0.2126, 0.7152, 0.0722)); }
