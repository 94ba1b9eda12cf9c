// What a frame keeps beside colour (protocol Aov); renderer/passes/aovs has the same places. All but the count
// are multiplied by opacity and blended as colour is; the count has no alpha, so that it adds up.
layout(location = 1) out vec4 aov_position;
layout(location = 2) out vec4 aov_normal;
layout(location = 3) out vec4 aov_tangent;
layout(location = 4) out vec4 aov_albedo;
layout(location = 5) out vec4 aov_direct;
layout(location = 6) out vec4 aov_light;  // light that is left, light without shadows
layout(location = 7) out vec4 aov_shell_count;

#include "known.glsl"

// Takes direct_light and light_share from lighting.glsl. `shells` is 1 for fur, 0 for skin.
void write_aovs(vec3 place, vec3 normal, vec3 tangent, vec3 albedo, float shells, float opacity) {
  aov_position = vec4(known(place), 1.0) * opacity;
  aov_normal = vec4(known(normal), 1.0) * opacity;
  aov_tangent = vec4(known(tangent), 1.0) * opacity;
  aov_albedo = vec4(known(albedo), 1.0) * opacity;
  aov_direct = vec4(known(direct_light), 1.0) * opacity;
  aov_light = vec4(light_share, 0.0, 1.0) * opacity;
  aov_shell_count = vec4(shells, 0.0, 0.0, 0.0);
}

// Fur beside what was written or added before.
void add_aovs(vec3 place, vec3 normal, vec3 tangent, vec3 albedo, float opacity) {
  aov_position += vec4(known(place), 1.0) * opacity;
  aov_normal += vec4(known(normal), 1.0) * opacity;
  aov_tangent += vec4(known(tangent), 1.0) * opacity;
  aov_albedo += vec4(known(albedo), 1.0) * opacity;
  aov_direct += vec4(known(direct_light), 1.0) * opacity;
  aov_light += vec4(light_share, 0.0, 1.0) * opacity;
}
