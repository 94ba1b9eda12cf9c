// The GLSL definitions of the names that renderer/shaders/shared uses; renderer/optics/lanes-inl.h has those for C++.
#define FUNCTION
#define Real float
#define Vec2 vec2
#define Vec3 vec3
#define Vec4 vec4
#define Mask bool
#define Index uint
#define In(type) type  // a parameter that is only read; C++ does not copy it

float select(bool mask, float yes, float no) { return mask ? yes : no; }
vec3 select(bool mask, vec3 yes, vec3 no) { return mask ? yes : no; }
bool any_lane(bool mask) { return mask; }
bool both(bool a, bool b) { return a && b; }
bool either(bool a, bool b) { return a || b; }
float mul_add(float a, float b, float c) { return a * b + c; }
float atan2(float y, float x) { return x == 0.0 && y == 0.0 ? 0.0 : atan(y, x); }
// Returns the unit vector, or 0 for a vector of length 0.
vec3 unit(vec3 a) { return a * (1.0 / max(length(a), 1e-20)); }
