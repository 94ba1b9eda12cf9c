#version 450 core
// Finds how much of the sky is hidden from each position of the ground's map: sky_over_ground of
// renderer/raster/sky_over_ground.cpp, a position a lane.
#include "../../shaders/constants.glsl"
#include "scene.glsl"
#include "columns.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = columns_storage) readonly buffer ColumnWords {
  uint top;
  uint column_words[];
};
layout(std430, binding = sky_storage) writeonly buffer Sky { float sky[]; };

// Returns direction i of a set of cosine-weighted samples of a uniform sky: a spiral on the disc (Vogel 1979), lifted to
// the hemisphere.
vec3 sky_direction(int i) {
  float square = (float(i) + 0.5) / float(sky_directions), angle = 2.399963 * float(i);
  return vec3(sqrt(square) * cos(angle), sqrt(1.0 - square), sqrt(square) * sin(angle));
}

// Returns whether a ray from a position hits anything.
bool stops(vec3 from, vec3 direction) {
  vec3 low = grid_low, high = low + grid_cell * vec3(grid_size);
  float begin = 0.0, end = (height_of(top) - from.y) / direction.y;
  for (int axis = 0; axis < 3; axis += 2) {
    float over = 1.0 / (abs(direction[axis]) > 1e-6 ? direction[axis] : 1e-6);
    float a = (low[axis] - from[axis]) * over, b = (high[axis] - from[axis]) * over;
    begin = max(begin, min(a, b));
    end = min(end, max(a, b));
  }
  float step = 2.0 * grid_cell;
  for (float t = begin + 0.5 * step; t < end; t += step) {
    vec3 at = from + t * direction;
    uint column = 2 * column_of(at), height = word_of(at.y);
    if (height >= column_words[column] && height <= column_words[column + 1]) return true;
  }
  return false;
}

void main() {
  uint at = lane_number();
  if (at >= uint(sky_size.x * sky_size.y)) return;
  vec2 position = sky_low + sky_cell * vec2(at % uint(sky_size.x), at / uint(sky_size.x));
  int stopped = 0;
  for (int i = 0; i < sky_directions; ++i) stopped += int(stops(vec3(position.x, ground_height, position.y), sky_direction(i)));
  sky[at] = float(stopped) / float(sky_directions);
}
