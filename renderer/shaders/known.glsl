// What is interpolated over a triangle that is all but a line on the screen may not be a number: nothing is drawn of it.
vec4 known(vec4 value) { return any(isnan(value)) || any(isinf(value)) ? vec4(0.0) : value; }
