// Divides triangles of the model into equal parts that are small compared to the grid's cells.
layout(std430, binding = vertices_storage) readonly buffer Vertices { float vertices[]; };  // position and normal of each
layout(std430, binding = triangles_storage) readonly buffer Triangles { uint triangles[]; };

vec3 corner_position(uint triangle, uint k) {
  uint at = 6 * triangles[3 * triangle + k];
  return vec3(vertices[at], vertices[at + 1], vertices[at + 2]);
}

struct TriangleParts {
  vec3 a, u, v;  // corner a, and the sides of a part in the directions from a to b and from b to c
  uint count;
};

// Divides a triangle into parts whose sides are at most `longest`, or 1/4096 of the triangle's.
TriangleParts parts_of(vec3 a, vec3 b, vec3 c, float longest) {
  float side = max(length(b - a), max(length(c - b), length(a - c)));
  uint along = 1;
  for (; side > longest && along < 4096; side *= 0.5) along *= 2;
  return TriangleParts(a, (b - a) / float(along), (c - b) / float(along), along * along);
}

// Returns the middle of a part. Parts lie in rows from corner a on; each row has two more than the one before.
vec3 middle_of(TriangleParts parts, uint part) {
  uint row = uint(sqrt(float(part)));
  row -= uint(row * row > part);
  row += uint((row + 1) * (row + 1) <= part);
  uint in_row = part - row * row;
  bool turned = in_row % 2 == 1;
  vec2 at = vec2(row, in_row / 2) + (turned ? vec2(1, 2) : vec2(2, 1)) / 3.0;
  return parts.a + at.x * parts.u + at.y * parts.v;
}
