// Encodes premultiplied linear light as straight sRGB: exposure, tone mapping and background, with the settings in
// `encoding` (renderer/finish/encode.h).

// Tone maps with a shoulder and a toe (Narkowicz 2015, a fit of the ACES curve), scaled so that .18 stays about .18.
FUNCTION Real film(Real light) {
  Real x = min(light, 1e4f) * 0.72f;
  return clamp(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 0.0f, 1.0f);
}

FUNCTION Real to_srgb(Real linear) {
  Real high = 1.055f * pow(max(linear, 0.0031308f), 1.0f / 2.4f) - 0.055f;
  return select(linear < 0.0031308f, 12.92f * linear, high);
}

// Returns the linear colour of a sheet of paper, lit from above: darker towards the top and the corners. `x`, `y`:
// pixels.
FUNCTION Vec3 studio_sheet(Real x, float y) {
  Real across = x * (1.0f / float(encoding.width));
  float down = y / float(encoding.height), down_off = down - 0.55f;
  Real across_off = (across - 0.5f) * 1.1f;
  Real square = across_off * across_off + down_off * down_off;
  Vec3 sheet = mix(Vec3(0.30f, 0.315f, 0.335f), Vec3(0.62f, 0.615f, 0.60f), smoothstep(Real(-0.1f), Real(1.0f), Real(down)));
  return sheet * (1.0f - 0.55f * smoothstep(Real(0.1f), Real(1.0f), 1.6f * square));
}

FUNCTION Real fraction_of(Real x) { return x - floor(x); }

// Returns noise within half a step of a channel, which avoids bands in the gradient: interleaved gradient noise
// (Jimenez 2014).
FUNCTION Real dither(Real x, float y) {
  Real noise = fraction_of(52.9829189f * fraction_of(floor(x) * 0.06711056f + floor(y) * 0.00583715f));
  return (noise - 0.5f) * (0.98f / float(encoding.largest));
}

// Returns the colour and opacity of a pixel with that light.
FUNCTION Vec4 encoded(Real x, float y, Vec3 light, Real coverage) {
  Real alpha = clamp(coverage, 0.0f, 1.0f);
  Mask seen = alpha > 0.0f;
  Vec3 colour = light * (encoding.exposure / select(seen, alpha, Real(1.0f)));
  colour = select(seen, colour, Vec3(0.0f));
  if (encoding.filmic) colour = Vec3(film(colour.x), film(colour.y), film(colour.z));
  if (!encoding.filmic) colour = clamp(colour, 0.0f, 1.0f);
  if (!encoding.transparent) {
    Vec3 behind = Vec3(encoding.background);
    if (encoding.studio) behind = studio_sheet(x, y);
    colour = mix(behind, colour, alpha);
  }
  colour = Vec3(to_srgb(colour.x), to_srgb(colour.y), to_srgb(colour.z));
  if (encoding.studio) colour += Vec3(dither(x, y) * (1.0f - alpha));
  Real opacity = Real(1.0f);
  if (encoding.transparent) opacity = alpha;
  return Vec4(colour.x, colour.y, colour.z, opacity);
}
