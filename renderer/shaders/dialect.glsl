// The words of renderer/shaders/shared in GLSL; renderer/optics/lanes-inl.h has them in C++.
#define FUNCTION
#define Real float
#define Vec3 vec3
#define Vec4 vec4
#define Mask bool
#define Index uint

float select(bool mask, float yes, float no) { return mask ? yes : no; }
vec3 select(bool mask, vec3 yes, vec3 no) { return mask ? yes : no; }
bool any_lane(bool mask) { return mask; }
float mul_add(float a, float b, float c) { return a * b + c; }
bool both(bool a, bool b) { return a && b; }
// Unit, or 0 for what has no direction.
vec3 unit(vec3 a) { return a * (1.0 / max(length(a), 1e-20)); }
