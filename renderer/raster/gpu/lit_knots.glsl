// The knots of a strand that are lit: LitKnots of renderer/raster/strand_light-inl.h.
const int max_points = 16;

struct LitKnots {
  int first, count;
};

LitKnots lit_knots(int segments, bool from_root) {
  LitKnots lit = LitKnots(0, segments > 8 ? min(segments / 4 + 1, max_points) : 4);
  if (!from_root) lit = LitKnots(segments / 3, max(lit.count - lit.count / 4, 2));
  return lit;
}
int lit_knot(LitKnots lit, int segments, int point) {
  return lit.first + point * (segments - lit.first) / (lit.count - 1);
}

// unpack_colour of renderer/strands/strand_set.h.
vec3 unpacked_colour(uint word) {
  vec3 share = vec3(word & 1023u, word >> 10 & 1023u, word >> 20 & 1023u) * (1.0 / 1023.0);
  return 4.0 * share * share;
}
