// Which strands a frame may keep of which parts; strand_plan.h mirrors it. Strands lie in groups of one part.
struct Part {
  vec3 back;         // from the middle of its skin to the camera, unit
  float min_facing;  // cosine to it of a root's normal from which on its strand is kept
  uint points, words;  // in the pools: first point, first word of its colours
  uint count;          // strands, of which
  uint kept;           // the first so many may be drawn
  float exact, whole;  // how many are kept, how much wider each is
  uint first;          // lane of its first strand
  uint number;         // of its first strand in the whole coat
  int segments;
  bool is_curve, has_mean;
  uint last;  // strands that face the camera, with all before the last of them; found by keep.comp
  uint lit_of;
  float own_colour;
  float wider, packing;
  float crowding;
  float coat;  // as pictures name it
  float unused[2];
};

layout(std430, binding = plan_storage) buffer Plan {
  uvec2 groups[max_strand_groups];  // part, first strand in it
  Part parts[];
};

// Returns how many of the part's first strands are drawn down to their roots.
uint whole_strands(Part part) { return (max(part.last, 1u) - 1) / deep_of + 1; }
// Returns how many of the part's first strands are lit and share their light with the others.
uint lit_strands(Part part) { return (max(part.last, 1u) - 1) / part.lit_of + 1; }
// Returns how many of the first lit strands are lit from the root on.
uint lit_whole(Part part) { return part.is_curve ? lit_strands(part) : whole_strands(part); }
