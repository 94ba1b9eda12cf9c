// The strand of a lane, and whether it is kept: keep_strands of renderer/raster/cull.cpp.
struct KeptStrand {
  uint part, strand;
  bool there;     // it is kept
  float widened;  // factor on its width
};

KeptStrand kept_strand(uint group, uint lane) {
  KeptStrand kept;
  kept.part = groups[group].x;
  kept.strand = groups[group].y + lane;
  Part part = parts[kept.part];
  kept.there = kept.strand < part.kept &&
               dot(root_normal(part, min(kept.strand, part.count - 1)), part.to_camera) >= part.min_facing;
  float left = part.exact < float(part.count) ? min((part.exact - float(kept.strand)) / (0.125 * part.exact), 1.0) : 1.0;
  kept.widened = part.width_factor * max(left, 1e-6);  // above 0: the last strand may have faded to nothing
  return kept;
}
