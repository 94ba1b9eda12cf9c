#version 450 core
out vec3 tuft_root;
out float tuft_length;

// Across the picture x of the root goes from 0 to 1; down the picture the length of the fur goes from 0 to .2.
void main() {
  vec2 at = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
  tuft_root = vec3(at.x, 0.5, 0.5);
  tuft_length = 0.2 * at.y;
  gl_Position = vec4(2.0 * at - 1.0, 0.0, 1.0);
}
