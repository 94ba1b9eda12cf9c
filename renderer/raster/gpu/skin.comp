#version 450 core
// Finds which triangle of the skin is nearest in each pixel of the box: renderer/raster/skin.cpp, several lanes for
// each triangle. The first pass finds 1 / distance, the second the first triangle at that distance.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Vertices { float vertices[]; };  // position and normal of each
layout(std430, binding = 1) readonly buffer Triangles { uint triangles[]; };
layout(std430, binding = 2) buffer SkinPixels { uint skin_pixels[]; };  // for each pixel: bits of 1 / distance (0 for none), triangle
uniform bool naming;  // second pass
uniform uint lanes_a_triangle;  // the rows of a triangle are dealt out to them in turn

// A corner projected to the picture. In double precision, because those of near triangles lie millions of pixels away.
struct FlatCorner {
  dvec2 at;
  double inverse;
};

dvec3 in_view(uint vertex) {
  dvec3 apart = dvec3(vec3(vertices[6 * vertex], vertices[6 * vertex + 1], vertices[6 * vertex + 2]) - camera_position);
  return dvec3(dot(apart, dvec3(camera_right)), dot(apart, dvec3(camera_up)), dot(apart, dvec3(camera_forward)));
}

FlatCorner flat_corner(dvec3 corner) {
  double inverse = 1.0lf / corner.z, scale = inverse * double(camera_scale);
  return FlatCorner(dvec2(camera_middle) + dvec2(corner.x, -corner.y) * scale, inverse);
}

void write_nearest(ivec2 pixel, float found, uint triangle) {
  if (!(found > 0.0)) return;
  uint at = 2 * pixel_index(pixel), bits = floatBitsToUint(found);
  if (!naming) atomicMax(skin_pixels[at], bits);
  else if (skin_pixels[at] == bits) atomicMin(skin_pixels[at + 1], triangle);
}

void cover_row(FlatCorner a, FlatCorner b, FlatCorner c, double area, int y, ivec2 columns, uint triangle) {
  const double overlap = 1e-3lf;  // pixels by which neighbouring triangles overlap, so that no pixel is missed between them
  dvec2 from[3] = dvec2[3](b.at, c.at, a.at), to[3] = dvec2[3](c.at, a.at, b.at);
  dvec3 inverses = dvec3(a.inverse, b.inverse, c.inverse), at, across;
  double low = double(columns.x), high = double(columns.y);
  dvec2 first = dvec2(box.xy) + dvec2(0.5lf, double(y) + 0.5lf);
  for (int i = 0; i < 3; ++i) {
    dvec2 edge = (to[i] - from[i]) / area, off = first - from[i];
    at[i] = edge.x * off.y - edge.y * off.x;
    across[i] = -edge.y;
    if (across[i] > 0.0lf) low = max(low, -at[i] / across[i]);
    if (across[i] < 0.0lf) high = min(high, -at[i] / across[i]);
    if (across[i] == 0.0lf && at[i] < 0.0lf) return;
  }
  if (!(low <= high + overlap)) return;
  int begin = max(int(ceil(low - overlap)), columns.x), end = min(int(floor(high + overlap)), columns.y);
  float found = float(dot(at + across * double(begin), inverses)), rise = float(dot(across, inverses));
  for (int x = begin; x <= end; ++x) write_nearest(ivec2(x, y), found + rise * float(x - begin), triangle);
}

void cover(FlatCorner a, FlatCorner b, FlatCorner c, uint triangle, uint lane) {
  dvec2 low = min(min(a.at, b.at), c.at) - dvec2(box.xy), high = max(max(a.at, b.at), c.at) - dvec2(box.xy);
  dvec2 size = dvec2(box.zw - box.xy);
  if (!(high.x > 0.0lf && low.x < size.x && high.y > 0.0lf && low.y < size.y)) return;
  dvec2 ab = b.at - a.at, ac = c.at - a.at;
  double area = ab.x * ac.y - ab.y * ac.x;
  if (!(abs(area) > 1e-12lf)) return;
  ivec2 first = ivec2(clamp(floor(low), dvec2(0.0lf), size - 1.0lf));
  ivec2 last = ivec2(clamp(floor(high), dvec2(0.0lf), size - 1.0lf));
  for (int y = first.y + int(lane); y <= last.y; y += int(lanes_a_triangle))
    cover_row(a, b, c, area, y, ivec2(first.x, last.x), triangle);
}

// Clips a triangle at the nearest distance (Sutherland and Hodgman 1974) and covers what is left: a fan of up to two
// triangles.
void clip_and_cover(dvec3 corners[3], uint triangle, uint lane) {
  const double min_depth = double(near_distance);
  FlatCorner fan[4];
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    dvec3 a = corners[i], b = corners[(i + 1) % 3];
    if (a.z >= min_depth) fan[count++] = flat_corner(a);
    if ((a.z >= min_depth) != (b.z >= min_depth)) {
      dvec3 between = a + (b - a) * ((min_depth - a.z) / (b.z - a.z));
      fan[count++] = flat_corner(dvec3(between.xy, min_depth));
    }
  }
  for (int i = 2; i < count; ++i) cover(fan[0], fan[i - 1], fan[i], triangle, lane);
}

void main() {
  uint triangle = lane_number() / lanes_a_triangle;
  if (triangle >= triangle_count) return;
  dvec3 corners[3];
  for (uint k = 0; k < 3; ++k) corners[k] = in_view(triangles[3 * triangle + k]);
  clip_and_cover(corners, triangle, lane_number() % lanes_a_triangle);
}
