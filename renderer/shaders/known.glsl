// Returns the value, or 0 if it is NaN or infinite: interpolation over a triangle that is nearly a line on the screen
// may give that.
vec4 known(vec4 value) { return any(isnan(value)) || any(isinf(value)) ? vec4(0.0) : value; }
