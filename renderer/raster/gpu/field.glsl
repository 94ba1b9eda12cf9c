// A field on the model, stored for each vertex: RasterScene::field.
layout(std430, binding = triangles_storage) readonly buffer Triangles { uint triangles[]; };
layout(std430, binding = field_storage) readonly buffer Field { float field[]; };

vec3 field_at(uint triangle, float b, float c) {
  vec3 sum = vec3(0.0);
  for (uint k = 0; k < 3; ++k) {
    uint at = 3 * triangles[3 * triangle + k];
    sum += (k == 0 ? 1.0 - b - c : k == 1 ? b : c) * vec3(field[at], field[at + 1], field[at + 2]);
  }
  return sum;
}
