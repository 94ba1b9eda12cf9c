#version 450 core
#include "fur_fragment.glsl"

vec3 light_on(Fibre fibre, vec4 hull) { return fibre_light(fibre, hull); }
