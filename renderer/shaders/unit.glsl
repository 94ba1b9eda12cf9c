// Unit, or 0 for what has no direction.
vec3 safe_unit(vec3 v) { return v / max(length(v), 1e-20); }
