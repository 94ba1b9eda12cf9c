// All shading models (science.md 4) for one strand; renderer/shading has them in double precision. Reads the block
// `scattering`. The includer defines azimuthal_light: the sum over R, TT, TRT and the residual of Ap Np averaged over
// the fibre's width, weighted by their longitudinal terms.

FUNCTION Vec3 scatter_kajiya(Fibre s, Vec3 to_light) {
  Real diffuse = sine_power(dot(s.tangent, to_light), scattering.exponents.x);
  Vec3 middle = unit_or_zero(to_light + s.to_camera);
  Real specular = sine_power(dot(s.tangent, middle), s.shine.exponent * scattering.exponents.y);
  return scattering.weights.x * diffuse * s.colour + Vec3(s.shine.weight * scattering.weights.y * specular);
}

// The cosine to the mirror direction is computed from its sine, for precision where it is close to 1.
FUNCTION Vec3 scatter_kajiya_kay(Fibre s, Vec3 to_light) {
  Real along_light = dot(s.tangent, to_light), along_view = dot(s.tangent, s.to_camera);
  Real sine_light = sine_to(along_light), sine_view = sine_to(along_view);
  Real mirror = sine_light * sine_view - along_light * along_view;
  Real off_mirror = sine_light * along_view + sine_view * along_light;
  Real lobe = sine_power(select(mirror > 0.0f, off_mirror, 1.0f), s.shine.exponent * scattering.exponents.y);
  return scattering.weights.x * sine_light * s.colour + Vec3(s.shine.weight * scattering.weights.y * lobe);
}

FUNCTION Vec3 scatter_scheuermann(Fibre s, Vec3 to_light) {
  Vec3 middle = unit_or_zero(to_light + s.to_camera);
  Real spread = scattering.weights.w * (2.0f * s.number - 1.0f);
  Vec3 first_axis = unit_or_zero(s.tangent + (scattering.shifts.x + spread) * s.normal);
  Vec3 second_axis = unit_or_zero(s.tangent + (scattering.shifts.y + spread) * s.normal);
  Real first = scheuermann_lobe(dot(first_axis, middle), s.shine.exponent * scattering.exponents.y);
  Real second = scheuermann_lobe(dot(second_axis, middle), scattering.exponents.z);
  Real wrapped = clamp(0.25f + 0.75f * dot(s.normal, to_light), 0.0f, 1.0f);
  return (scattering.weights.x * wrapped + scattering.weights.z * second) * s.colour +
         Vec3(s.shine.weight * scattering.weights.y * first);
}

// Returns the longitudinal terms of R, TT, TRT and the residual.
FUNCTION Vec4 longitudinal_lobes(Real sine_light, FibreViewTerms view_terms) {
  return Vec4(longitudinal_lobe(sine_light, view_terms, scattering.tilt_sine.x, scattering.tilt_cosine.x,
                                scattering.over_variance.x, scattering.normaliser.x),
              longitudinal_lobe(sine_light, view_terms, scattering.tilt_sine.y, scattering.tilt_cosine.y,
                                scattering.over_variance.y, scattering.normaliser.y),
              longitudinal_lobe(sine_light, view_terms, scattering.tilt_sine.z, scattering.tilt_cosine.z,
                                scattering.over_variance.z, scattering.normaliser.z),
              longitudinal_lobe(sine_light, view_terms, scattering.tilt_sine.w, scattering.tilt_cosine.w,
                                scattering.over_variance.w, scattering.normaliser.w));
}

FUNCTION Vec4 marschner_lobes(Real sine_light, Real sine_view, Real cos_difference) {
  Real middle = 0.5f * (inclination_of(sine_light) + inclination_of(sine_view));
  return Vec4(marschner_lobe(middle, cos_difference, scattering.centre.x, scattering.over_variance.x, scattering.normaliser.x),
              marschner_lobe(middle, cos_difference, scattering.centre.y, scattering.over_variance.y, scattering.normaliser.y),
              marschner_lobe(middle, cos_difference, scattering.centre.z, scattering.over_variance.z, scattering.normaliser.z),
              marschner_lobe(middle, cos_difference, scattering.centre.w, scattering.over_variance.w, scattering.normaliser.w));
}

FUNCTION Vec3 absorption_coordinates(Vec3 colour) {
  if (scattering.model.y == 1) return Vec3(scattering.absorption);
  return exp2(scattering.exponents.w * log2(clamp(colour, 1e-6f, 1.0f)));
}

FUNCTION FibreViewTerms fibre_view_terms(Fibre s) {
  Real along = dot(s.tangent, s.to_camera);
  FibreViewTerms view_terms;
  view_terms.sine = clamp(-along, -1.0f, 1.0f);
  view_terms.cosine = sine_to(view_terms.sine);
  view_terms.aside = s.to_camera - s.tangent * along;
  view_terms.absorption = absorption_coordinates(s.colour);
  return view_terms;
}

// Single scattering of the two fibre models.
FUNCTION Vec3 scatter_fibre(Fibre s, FibreViewTerms view_terms, Vec3 to_light, bool marschner) {
  Real sine_light = clamp(-dot(s.tangent, to_light), -1.0f, 1.0f), azimuth = azimuth_between(s.tangent, view_terms.aside, to_light);
  if (marschner) {
    Real cos_difference = cos_half_difference(sine_light, view_terms.sine);
    Vec4 along = marschner_lobes(sine_light, view_terms.sine, cos_difference);
    return 3.14159265f * sine_to(sine_light) * azimuthal_light(along, azimuth, cos_difference, view_terms.absorption);
  }
  return 3.14159265f * azimuthal_light(longitudinal_lobes(sine_light, view_terms), azimuth, view_terms.cosine, view_terms.absorption);
}

// Returns the light that leaves a bundle of fibres after multiple scattering. The fibre models scatter once; without
// this term pale fur turns grey and red fur brown (dual scattering in spirit; science.md 4).
FUNCTION Vec3 scatter_again(Fibre s, Vec3 to_light) {
  return 0.55f * scattering.weights.x * sine_to(dot(s.tangent, to_light)) * s.colour;
}

// Returns single scattering `once` plus multiple scattering.
FUNCTION Vec3 scatter_bundle(Fibre s, Vec3 to_light, Vec3 once) { return 0.6f * once + scatter_again(s, to_light); }

// Returns the light scattered to the camera for light of radiance 1, without shadow, backlight_fade and ambient light.
// Only fibre models read `view_terms`.
FUNCTION Vec3 scatter(int model, Fibre s, FibreViewTerms view_terms, Vec3 to_light) {
  if (scatters_fibres(model)) return scatter_bundle(s, to_light, scatter_fibre(s, view_terms, to_light, model == model_marschner));
  if (model == model_scheuermann) return scatter_scheuermann(s, to_light);
  if (model == model_kajiya_kay) return scatter_kajiya_kay(s, to_light);
  return scatter_kajiya(s, to_light);
}
