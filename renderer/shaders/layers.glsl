// What a frame keeps beside colour (protocol FrameLayer); renderer/passes/layers has the same places. All but the count
// are multiplied by opacity and blended as colour is; the count has no alpha, so that it adds up.
layout(location = 1) out vec4 layer_position;
layout(location = 2) out vec4 layer_normal;
layout(location = 3) out vec4 layer_tangent;
layout(location = 4) out vec4 layer_albedo;
layout(location = 5) out vec4 layer_direct;
layout(location = 6) out vec4 layer_light;  // light that is left, light without shadows
layout(location = 7) out vec4 layer_count;

#include "known.glsl"

// Takes direct_light and light_share from lighting.glsl. `shells` is 1 for fur, 0 for skin.
void write_layers(vec3 place, vec3 normal, vec3 tangent, vec3 albedo, float shells, float opacity) {
  layer_position = vec4(known(place), 1.0) * opacity;
  layer_normal = vec4(known(normal), 1.0) * opacity;
  layer_tangent = vec4(known(tangent), 1.0) * opacity;
  layer_albedo = vec4(known(albedo), 1.0) * opacity;
  layer_direct = vec4(known(direct_light), 1.0) * opacity;
  layer_light = vec4(light_share, 0.0, 1.0) * opacity;
  layer_count = vec4(shells, 0.0, 0.0, 0.0);
}

// Fur beside what was written or added before.
void add_layers(vec3 place, vec3 normal, vec3 tangent, vec3 albedo, float opacity) {
  layer_position += vec4(known(place), 1.0) * opacity;
  layer_normal += vec4(known(normal), 1.0) * opacity;
  layer_tangent += vec4(known(tangent), 1.0) * opacity;
  layer_albedo += vec4(known(albedo), 1.0) * opacity;
  layer_direct += vec4(known(direct_light), 1.0) * opacity;
  layer_light += vec4(light_share, 0.0, 1.0) * opacity;
}
