// The plan of a box: which strands of which parts it may keep, in groups of strands of one part. strand_plan.h mirrors the
// layout.
struct Part {
  vec3 to_camera;           // direction from the middle of its skin to the camera, unit
  float min_facing;    // smallest cosine between a root's normal and `to_camera` of a strand that is kept
  uint points, words;  // in the pools: index of its first point, and of the first word of its colours
  uint count;          // number of strands
  uint kept;           // only the first `kept` strands may be drawn
  float exact, width_factor;  // of StrandCull (renderer/raster/cull.h)
  uint first;          // lane of its first strand, over all groups
  uint number;         // strands of all parts before it
  int segments;        // of each strand
  bool is_curve, has_mean;  // its strands are curves; they have a factor to the mean strand's colour (to_mean)
  uint last;           // 1 + the last kept strand, which keep.comp finds; 0 if there is none
  uint lit_of;         // strands in a group of which one is lit
  float own_colour;    // share of a strand's colour that is its own; the rest is the mean's
  float wider, packing;  // of GrownPart
  float crowding;        // of GrownPart
  float coat;            // coat_number of renderer/raster/raster_scene.h
  float unused[2];
};

layout(std430, binding = plan_storage) buffer Plan {
  uvec2 groups[max_strand_groups];  // index of the part, first strand of the group in that part
  Part parts[];
};

// Returns how many of the part's first strands are drawn down to their roots.
uint strands_from_root(Part part) { return (max(part.last, 1u) - 1) / deep_strand_factor + 1; }
// Returns how many of the part's first strands are lit and share their light with the others.
uint lit_strands(Part part) { return (max(part.last, 1u) - 1) / part.lit_of + 1; }
// Returns how many of the first lit strands are lit from the root on.
uint lit_from_root(Part part) { return part.is_curve ? lit_strands(part) : strands_from_root(part); }
