// What every stage knows of the scene (renderer/raster/raster_scene.h). Layout std140; scene_block.h mirrors it.
layout(std140, binding = raster_binding) uniform RasterBlock {
  vec3 camera_position;
  float camera_scale;  // pixels of a size at distance 1
  vec3 camera_right;
  float oversampling;
  vec3 camera_up;
  float over_view;
  vec3 camera_forward;
  float wetness;  // of the coat
  vec2 camera_middle;
  ivec2 tiles;  // across and down the box
  ivec4 box;    // left, top, right, bottom, pixels
  vec3 grid_low;
  float grid_cell;
  ivec3 grid_size;
  bool grid_there;
  float near_cell;
  uint fur_group_count;
  bool near_there;
  bool far_lights;
  int shading_model;
  uint light_count;
  uint key_furthest;
  int key_shift;
  uint triangle_count;
  uint strand_count;  // that may be kept, in whole groups of strand_group
  uint knot_room;
  uint entry_room;
  uint lit_point_room;
  uint texel_levels;  // of the model's pictures; 0 for none
  bool model_colours;
  int eye_count;
  float ground_height;
  float ground_contact;
  float ground_shadow;
  float sky_cell;
  vec2 sky_low;
  ivec2 sky_size;
  int eye_steps;
  vec4 light_widths[max_lights];  // radius, or the tangent of half the angle of a far one; 1 for a far one
  ivec4 eye_boxes[max_eyes];      // pixels that an eye may touch
};

// A knot of a strand on the picture.
struct Knot {
  vec2 at;          // pixels
  float inverse;    // one over the distance along the view; 0 for what is too near to be drawn
  float thickness;  // half of it, pixels
};

// A place on a piece of the skin.
struct PieceCorners {
  uint piece;
  float b, c;  // shares of the second and the third corner
};

const uint strand_group = 64;  // of strands of one part
const uint root_words = 9;  // StrandRoot, FurCorner
const uint corner_words = 15;
const uint knot_bit = 0x40000000;  // of numbers of knots that go as floats

// Returns the ray through a position of the picture; its component along the view is 1.
vec3 ray_through(vec2 pixel) {
  vec2 off = (pixel - camera_middle) * (1.0 / camera_scale);
  return camera_forward + off.x * camera_right - off.y * camera_up;
}

// In a dispatch of rows of groups, of strand_group lanes each.
uint group_number() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
uint lane_number() { return group_number() * strand_group + gl_LocalInvocationIndex; }

// Pixels lie tile by tile, in a tile row by row. From the corner of the box:
uint pixel_index(ivec2 at) {
  uvec2 pixel = uvec2(at), tile = pixel / tile_side, off = pixel % tile_side;
  return (tile.y * uint(tiles.x) + tile.x) * tile_pixels + off.y * tile_side + off.x;
}
