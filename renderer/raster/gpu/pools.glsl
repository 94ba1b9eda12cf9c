// The strands of all parts (renderer/strands/strand_set.h). Each part has its points in one buffer, and in the other its
// colours, neighbours, roots and to_mean, one after the other.
layout(std430, binding = points_storage) readonly buffer Points { vec4 pool_points[]; };
layout(std430, binding = words_storage) readonly buffer Words { uint pool_words[]; };

vec4 point_of(Part part, uint strand, int knot) {
  return pool_points[part.points + strand * uint(part.segments + 1) + uint(knot)];
}
uint colour_word(Part part, uint strand, int knot) {
  return pool_words[part.words + strand * uint(part.segments + 1) + uint(knot)];
}
uint after_colours(Part part) { return part.words + part.count * uint(part.segments + 1); }
uint neighbour_of(Part part, uint strand) { return pool_words[after_colours(part) + strand]; }
uint root_at(Part part, uint strand) { return after_colours(part) + part.count + strand * root_words; }
float root_number(uint root, uint at) { return uintBitsToFloat(pool_words[root + at]); }
vec3 root_normal(Part part, uint strand) {
  uint root = root_at(part, strand);
  return vec3(root_number(root, 0), root_number(root, 1), root_number(root, 2));
}
float root_reach(Part part, uint strand) { return root_number(root_at(part, strand), 4); }
uint to_mean_word(Part part, uint strand) { return pool_words[root_at(part, part.count) + strand]; }

// Returns the strand whose light a strand takes: lit_strand of renderer/raster/kernels.h.
uint lit_strand(Part part, uint strand, uint own) {
  uint lit = strand;
  while (lit >= own) lit = neighbour_of(part, lit);
  return root_reach(part, strand) > 1.2 * root_reach(part, lit) ? strand : lit;
}
