// Projects strands onto the picture: renderer/raster/place-inl.h, a strand a lane.

Knot knot_of(Part part, uint strand, int number, float widened) {
  vec4 point = point_of(part, strand, number);
  vec3 apart = point.xyz - camera_position;
  float distance = dot(apart, camera_forward), inverse = 1.0 / max(distance, near_distance);
  float scale = inverse * camera_scale;
  Knot knot;
  knot.at = camera_middle + vec2(dot(apart, camera_right), -dot(apart, camera_up)) * scale;
  knot.inverse = distance > near_distance ? inverse : 0.0;
  knot.half_width = point.w * inverse * widened * camera_scale;
  return knot;
}

// Extent of a strand on the picture.
struct PlacedStrand {
  vec2 low, high; // its bounding box, pixels
  float arc_length;      // length along the strand, pixels
  float reach;    // distance from its root to its tip on the picture, pixels
  float longest;  // length of its longest segment, pixels
  float widest;   // largest half width, pixels
  float size;     // length along the strand, sizes
  vec3 root, tip;
};

PlacedStrand place_strand(Part part, uint strand, float widened) {
  PlacedStrand placed;
  placed.low = vec2(1e30);
  placed.high = vec2(-1e30);
  placed.arc_length = placed.longest = placed.widest = placed.size = 0.0;
  vec2 first, before;
  for (int k = 0; k <= part.segments; ++k) {
    Knot knot = knot_of(part, strand, k, widened);
    vec3 position = point_of(part, strand, k).xyz;
    if (k == 0) {
      placed.root = position;
      first = knot.at;
    } else {
      float segment = length(knot.at - before);
      placed.arc_length += segment;
      placed.longest = max(placed.longest, segment);
      placed.size += length(position - placed.tip);
    }
    placed.widest = max(placed.widest, knot.half_width);
    before = knot.at;
    placed.tip = position;
    if (!(knot.inverse > 0.0)) continue;
    placed.low = min(placed.low, knot.at - knot.half_width);
    placed.high = max(placed.high, knot.at + knot.half_width);
  }
  placed.reach = length(before - first);
  return placed;
}

// What determines how deep in the fur a strand is visible.
struct StrandDepth {
  vec3 root, tip, normal;
  float reach, over;  // StrandRoot::reach; length of the fur around the strand over nominal_length
};

StrandDepth strand_depth(Part part, uint strand, vec3 root, vec3 tip, float arc_length) {
  StrandDepth depth;
  depth.root = root;
  depth.tip = tip;
  depth.normal = root_normal(part, strand);
  depth.reach = root_reach(part, strand);
  float straight = max(length(tip - root), 0.02 * arc_length + 1e-9);
  float exposed_length = arc_length / (1.0 + curl_in_shadow * max(arc_length / straight - 1.0, 0.0));
  depth.over = exposed_length / max(depth.reach, 0.01) / nominal_length;
  return depth;
}

int slice_at(float height) { return int(clamp(height * float(slice_count), 0.0, float(slice_count) - 1.0)); }
float depth_above(float height) {
  int slice = slice_at(height);
  return frame.depth_above[slice / 4][slice % 4];
}

// Returns the last knot that is hidden because at least seen_depth strands lie in front of it; 0 for none.
int hidden_knot(Part part, StrandDepth strand) {
  vec3 to_camera = unit(camera_position - strand.root), along = unit(strand.tip - strand.root);
  float facing = dot(strand.normal, to_camera);
  int hidden = 0;
  for (int k = 1; k < part.segments; ++k) {
    float height = strand.reach * (float(k) / float(part.segments));
    float above = depth_above(height) * strand.over * part.crowding;
    if (!(strands_crossed(above, exit_path_length(height, facing), along, to_camera) >= seen_depth)) break;
    hidden = k;
  }
  return hidden;
}

// Returns the share of the skin that strands of radius 1 would fill: the flatter they lie, the more.
float packing_of(Part part, StrandDepth depth) {
  float upright = max(dot(unit(depth.tip - depth.root), depth.normal), 0.2);
  return 0.7 * part.packing / (part.wider * part.wider) / upright;
}
