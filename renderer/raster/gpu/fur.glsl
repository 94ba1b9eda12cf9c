// All strands of the fur, in groups of strands of one part. fur_cells.h mirrors the layout.
struct FurPart {
  uint points, words;  // in the pools: index of its first point, and of the first word of its colours
  uint count;          // number of strands
  uint summed;         // number of its first strands that are summed in the grid on behalf of all
  int segments;        // of each strand
  float each;          // strands that each summed one stands for
  bool near;           // it is in the near cells
  uint unused;
};
layout(std430, binding = fur_groups_storage) readonly buffer FurGroups { uvec2 fur_groups[]; };  // part, first strand in it
layout(std430, binding = fur_parts_storage) readonly buffer FurParts { FurPart fur_parts[]; };

// The strand of a lane.
struct FurStrand {
  FurPart part;
  uint strand;
  uint first;  // index of its root among the points
  bool there;
};

FurStrand fur_strand() {
  FurStrand own;
  own.there = group_number() < fur_group_count;
  if (!own.there) return own;
  uvec2 group = fur_groups[group_number()];
  own.part = fur_parts[group.x];
  own.strand = group.y + gl_LocalInvocationIndex;
  own.first = own.part.points + own.strand * uint(own.part.segments + 1);
  own.there = own.strand < own.part.count;
  return own;
}
