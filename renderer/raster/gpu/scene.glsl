// The uniforms of the scene that every stage reads (renderer/raster/raster_scene.h), and functions on them. Layout std140;
// scene_block.h mirrors it.
layout(std140, binding = raster_binding) uniform RasterBlock {
  vec3 camera_position;
  float camera_scale;  // pixels that a length of 1 size covers at distance 1
  vec3 camera_right;
  float oversampling;  // pixels of the picture along a side of a shown pixel
  vec3 camera_up;
  float over_view;  // factor from a distance to the length that the picture's longer side spans there
  vec3 camera_forward;
  float wetness;  // of the coat
  vec2 camera_middle;
  ivec2 tiles;  // number of tiles across and down the box
  ivec4 box;    // left, top, right, bottom, pixels
  vec3 grid_low;
  float grid_cell;
  ivec3 grid_size;
  bool grid_there;
  float near_cell;
  uint fur_group_count;
  bool near_there;
  bool directional_lights;
  int shading_model;
  uint light_count;
  uint key_furthest;
  int key_shift;
  uint triangle_count;
  uint strand_count;  // strands of the plan, in whole groups of strand_group
  uint knot_capacity;
  uint entry_capacity;
  uint lit_point_capacity;
  uint texel_levels;  // mip levels of the model's images; 0 for none
  bool model_colours;
  int eye_count;
  float ground_height;
  float ground_contact;
  float ground_shadow;
  float sky_cell;
  vec2 sky_low;
  ivec2 sky_size;
  int eye_steps;
  vec4 light_widths[max_lights];  // x: radius, or the tangent of a directional light's half angle; y: 1 if directional, else 0
  ivec4 eye_boxes[max_eyes];      // pixels that the eye may cover: left, top, right, bottom
};

// A knot of a strand, projected to the picture.
struct Knot {
  vec2 at;           // pixels
  float inverse;     // 1 / distance along the view; 0 if too near to be drawn
  float half_width;  // of the strand, pixels
};

// A position on a triangle of the model.
struct TriangleCorners {
  uint triangle;
  float b, c;  // barycentrics of the second and the third corner
};

const uint strand_group = 64;  // strands of one part in a work group
const uint root_words = 9;     // size of a StrandRoot
const uint corner_words = 15;  // size of a FurCorner
const uint knot_bit = 0x40000000;  // set in knot numbers that are stored as a float's bits, so that none is a denormal

// Returns the ray through a position of the picture; its component along the view is 1.
vec3 ray_through(vec2 pixel) {
  vec2 off = (pixel - camera_middle) * (1.0 / camera_scale);
  return camera_forward + off.x * camera_right - off.y * camera_up;
}

// Index of this work group, in a dispatch of several rows of groups; and of this lane, with strand_group lanes in a group.
uint group_number() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint lane_number() { return group_number() * strand_group + gl_LocalInvocationIndex; }

// Returns the index of a pixel of the box, relative to its corner. Pixels lie tile by tile, in a tile row by row.
uint pixel_index(ivec2 at) {
  uvec2 pixel = uvec2(at), tile = pixel / tile_side, off = pixel % tile_side;
  return (tile.y * uint(tiles.x) + tile.x) * tile_pixels + off.y * tile_side + off.x;
}
