#version 450 core
// One over the distance along the view, which is the skin's w.
layout(location = 0) out vec4 result;

void main() { result = vec4(gl_FragCoord.w, 0.0, 0.0, 1.0); }
