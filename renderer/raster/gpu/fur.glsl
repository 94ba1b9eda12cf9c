// All strands of a fur, in groups of one part: fur_cells.h mirrors it.
struct FurPart {
  uint points, words;  // in the pools: first point, first word of its colours
  uint count;          // strands
  uint summed;         // the first so many stand for all in the grid
  int segments;
  float each;          // strands that each of those stands for
  bool near;           // its single strands are looked for
  uint unused;
};
layout(std430, binding = fur_groups_storage) readonly buffer FurGroups { uvec2 fur_groups[]; };  // part, first strand in it
layout(std430, binding = fur_parts_storage) readonly buffer FurParts { FurPart fur_parts[]; };

// The strand of a lane.
struct FurStrand {
  FurPart part;
  uint strand;
  uint first;  // its root among the points
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
