// Shades the atlas's strands as thin fibres (Kajiya and Kay): diffuse by the sine to the light, and a highlight.
uniform sampler2D atlas;
uniform float layers;
uniform float columns;
uniform float ambient;
uniform vec3 toLights[LIGHTS];
uniform vec3 colours[LIGHTS];
in vec2 coat_uv;
in vec3 tangent;
in vec3 view;
in vec3 fur;
in float share;
flat in float layer;

const float headroom = 1.6;       // the atlas stores lightness divided by its mean and by this
const float deepest_light = .35;  // light at the skin relative to the tips, as in the export "shells"
const float sharpness = .5;       // scales the derivatives: one mipmap level finer, for strands rather than haze
const float inset = .5 / 256.;    // margin inside each atlas tile, in tiles; keeps neighbours from bleeding in

void main() {
  vec2 tile = clamp(fract(coat_uv), inset, 1. - inset);
  vec2 corner = vec2(mod(layer, columns), floor(layer / columns));
  // Derivatives of the coordinate before wrapping avoid a seam of coarse mipmap levels where the tile repeats.
  vec2 dx = sharpness * dFdx(coat_uv) / columns, dy = sharpness * dFdy(coat_uv) / columns;
  vec4 strand = textureGrad(atlas, (corner + tile) / columns, dx, dy);
  float opacity = strand.a * share;
  if (opacity < .02) discard;
  vec3 t = normalize(tangent), toView = normalize(view), light = vec3(ambient);
  float highlight = 0., above = mix(deepest_light, 1., (layer + .5) / layers);
  for (int i = 0; i < LIGHTS; ++i) {
    float along = dot(t, toLights[i]), across = sqrt(max(1. - along * along, 0.));
    light += colours[i] * across * .5;
    vec3 halfway = normalize(toLights[i] + toView);
    float slope = dot(t, halfway);
    highlight += .06 * pow(sqrt(max(1. - slope * slope, 0.)), 40.);
  }
  gl_FragColor = vec4(above * (fur * headroom * strand.rgb * light + highlight * light), opacity);
  #include <colorspace_fragment>
}
