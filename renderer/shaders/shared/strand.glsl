// Strands for shading. The files of this folder are both GLSL and C++: a Real is one number in GLSL (dialect.glsl) and
// one for each SIMD lane in C++ (renderer/optics/lanes-inl.h). Both define Real, Vec2, Vec3, Vec4, Mask, Index,
// FUNCTION, In, select, any_lane, both, either, mul_add, atan2, unit, and GLSL's mathematical functions. Numbers that
// are the same in all lanes are floats.

// Factors of painted water on the weight and exponent of highlights.
struct Shine {
  Real weight, exponent;
};

// Directions are unit and point away from the strand, the tangent from root to tip.
struct Fibre {
  Vec3 position;
  Vec3 normal, tangent, to_camera;
  Vec3 colour;   // C, [0, 1]
  Vec3 crossed;  // colour of the fur above, which light crosses
  Real height;   // s in [0, 1]
  Real above;    // strands above the position that a ray at 45 degrees to upright fur would cross
  Real number;   // random number of the strand, [0, 1]
  Shine shine;
};

// View-dependent values that all lights share; only fibre models need them.
struct FibreViewTerms {
  Real sine, cosine;  // of the inclination about the axis from tip to root
  Vec3 aside;         // direction to the camera, projected off the strand's axis
  Vec3 absorption;    // absorption coordinates of the three channels
};

// View-dependent values that shadows of all lights share.
struct FibreView {
  Real path, strands;  // path out of the fur to the camera (exit_path_length), and the strands on it
  Real widths;        // height of the fur above, in strand widths
};

struct Arriving {
  Vec3 to_light;  // unit
  Vec3 radiance;
};

// Returns (1 - d^2)^(n/2). Near d = 0 a series of the logarithm keeps the digits that 1 - d^2 loses.
FUNCTION Real sine_power(Real d, Real n) {
  Real x = d * d;
  Real series = -x * (1.0f + x * (0.5f + x * (0.33333333f + x * (0.25f + x * (0.2f + x * 0.16666667f)))));
  Real complement = max(1.0f - x, 1e-12f);
  Real power = exp(0.5f * n * select(x < 0.08f, series, log(complement)));
  return select(x >= 1.0f, select(n > 0.0f, 0.0f, 1.0f), power);
}

FUNCTION Real sine_to(Real cosine) { return sqrt(max(1.0f - cosine * cosine, 0.0f)); }

FUNCTION Vec3 unit_or_zero(Vec3 v) { return v * (1.0f / sqrt(max(dot(v, v), 1e-12f))); }

FUNCTION Real scheuermann_lobe(Real along, Real n) { return smoothstep(-1.0f, 0.0f, along) * sine_power(along, n); }

// Returns exp(-x) I0(x) for x >= 0, within a relative error of 4e-4: the inverse of its square is 1 + 2 x near 0 and 2
// pi x for large x, and a ratio of polynomials (our least-squares fit) between. No branch and no exponential, unlike
// Abramowitz and Stegun 9.8.1.
FUNCTION Real scaled_bessel_i0(Real x) {
  Real over = 1.0f + x * (2.37362723f + x * (2.65343988f + x * (1.1803919f + x * 1.1000664f)));
  Real under = 1.0f + x * (0.38860871f + x * (0.23850039f + x * 0.17503195f));
  return sqrt(under / over);
}

// Returns one lobe of Mp of d'Eon 2011. Sines are of inclinations about the axis from tip to root.
FUNCTION Real longitudinal_lobe(Real sine_light, FibreViewTerms view_terms, float tilt_sine, float tilt_cosine, float over_variance,
                                float normaliser) {
  Real cosine_light = sine_to(sine_light);
  Real tilted_sine = view_terms.sine * tilt_cosine + view_terms.cosine * tilt_sine;
  Real tilted_cosine = abs(view_terms.cosine * tilt_cosine - view_terms.sine * tilt_sine);
  Real apart = cosine_light - tilted_cosine, sum = sine_light + tilted_sine;
  Real fall = exp(-0.5f * (apart * apart + sum * sum) * over_variance) * normaliser;
  return fall * scaled_bessel_i0(cosine_light * tilted_cosine * over_variance);
}

// Returns the arc sine, radians, by the half angle, whose tangent lies in [-1, 1].
FUNCTION Real inclination_of(Real sine) {
  Real half_tangent = sine / (1.0f + sine_to(sine)), square = half_tangent * half_tangent;
  Real p = 0.0117212f;
  p = mul_add(p, square, -0.05265332f);
  p = mul_add(p, square, 0.11643287f);
  p = mul_add(p, square, -0.19354346f);
  p = mul_add(p, square, 0.33262347f);
  p = mul_add(p, square, -0.99997726f);
  return -2.0f * half_tangent * p;
}

// Returns cos theta_d, where theta_d is half the difference of two inclinations, from their sines: its square is (1 +
// cos(2 theta_d)) / 2.
FUNCTION Real cos_half_difference(Real sine_light, Real sine_view) {
  Real cos_full_difference = sine_to(sine_light) * sine_to(sine_view) + sine_light * sine_view;
  return sqrt(max(0.5f + 0.5f * cos_full_difference, 0.0f));
}

// Returns one lobe of M of Marschner 2003 over cos^2 theta_d.
FUNCTION Real marschner_lobe(Real middle, Real cos_difference, float centre, float over_variance, float normaliser) {
  Real apart = middle - centre;
  return exp(-0.5f * apart * apart * over_variance) * normaliser / max(cos_difference * cos_difference, 1e-3f);
}

// Returns |phi| between light and view around the strand, as the coordinate azimuth_coordinate of scattering_table.h:
// by the perimeter of a square, without an arc tangent. For a direction along the strand it is undefined; then it
// returns the middle of the range.
FUNCTION Real azimuth_between(Vec3 tangent, Vec3 aside, Vec3 to_light) {
  Vec3 light = to_light - tangent * dot(tangent, to_light);
  Real x = dot(aside, light), perimeter = abs(x) + abs(dot(tangent, cross(aside, light)));
  return select(perimeter > 1e-10f, 0.5f - 0.5f * x / max(perimeter, 1e-10f), 0.5f);
}

FUNCTION bool scatters_fibres(int model) { return model == model_energy_conserving || model == model_marschner; }

// Returns B of GPU fur eq 1, which fades out light from behind; 1 for models that handle light from behind themselves.
FUNCTION Real backlight_fade(int model, Real facing, float reach) {
  bool surface = model == model_lengyel || model == model_kajiya || model == model_kajiya_kay;
  if (!surface) return Real(1.0f);
  return select(facing < 0.0f, 1.0f - min(-facing, reach) / max(reach, 1e-20f), 1.0f);
}

// Returns the length of a ray's path out of the fur, over the height of fur above its start: longer at lower angles.
// From a height h below the tips, over a body of radius r, that is 2 / (n.d + sqrt((n.d)^2 + 2 h / r)).
FUNCTION Real exit_path_length(Real height, Real facing) {
  Real roundness = 0.2f * (1.0f - height) + 0.01f;  // 2 h / r, where fur is a tenth of the radius of what it grows on
  return 2.0f / (facing + sqrt(facing * facing + roundness));
}

// Returns the number of strands that a ray crosses on its way out, if one at 45 degrees to upright fur would cross
// `above`. It is proportional to the sine of the ray's angle to the strands.
FUNCTION Real strands_crossed(Real above, Real path, Vec3 tangent, Vec3 direction) {
  float spread = 0.08f;  // spread in direction of neighbouring strands
  Real along = dot(tangent, direction);
  return above * sqrt(1.0f - (1.0f - spread) * min(along * along, 1.0f)) * path;
}

// Returns the strands on the path to the light, less those that the view ray would also cross: the camera sees the
// fibre, so they are not there. This is the hot spot of leaf canopies (Kuusk 1985, "The hot spot effect of a uniform
// vegetative cover"). With N strands to the camera and M to the light, rays that separate by d strand widths share
// sqrt(N M) (1 - exp(-x)) / x of them, x = d / c; separation along the strands does not count. c would be 1/2 for any
// position in the fur. Visible positions stand out of their surroundings: 1/6 gives furry balls the light of strands,
// within .03, from the side and from above, lying and upright.
FUNCTION Real strands_not_shared(Fibre fibre, FibreView view, Vec3 to_light, Real path, Real strands) {
  Vec3 apart = fibre.to_camera * view.path - to_light * path;
  apart = apart - dot(apart, fibre.tangent) * fibre.tangent;
  Real x = 6.0f * view.widths * length(apart);
  Real share = (1.0f + x * 0.16666667f) / (1.0f + x * (0.66666667f + x * 0.16666667f));  // (1 - exp(-x)) / x within .02
  return max(strands - sqrt(max(view.strands * strands, 0.0f)) * share, 0.0f);
}
