// A strand as light finds it. What lies in this folder is GLSL and C++: of GLSL a number is a Real (dialect.glsl), of
// C++ so many as its lanes hold (renderer/optics/lanes-inl.h). Words of both: Real, Vec2, Vec3, Vec4, Mask, Index,
// FUNCTION, In, select, any_lane, both, either, mul_add, atan2, unit, and what GLSL has of mathematics. Numbers that
// are the same in all lanes are floats.

// What painted water does to highlights: factors on their weight and exponent.
struct Shine {
  Real weight, exponent;
};

// Directions are unit and point away from the strand, the tangent from root to tip.
struct Fibre {
  Vec3 place;
  Vec3 normal, tangent, to_camera;
  Vec3 colour;   // C, [0, 1]
  Vec3 crossed;  // colour of the fur above, which light crosses
  Real height;   // s in [0, 1]
  Real above;    // strands over the place that a ray at 45 degrees to upright fur would cross
  Real number;   // of the strand in [0, 1]
  Shine shine;
};

// What of its view all lights share; the fibre models alone need it.
struct FibreEye {
  Real sine, cosine;  // of the inclination about the axis from tip to root
  Vec3 aside;         // to the camera, less what lies along the strand
  Vec3 absorption;    // coordinates of the three channels
};

// The same of what shadows need.
struct FibreView {
  Real way, strands;  // out of the fur to the camera, and the strands on it
  Real widths;        // of the fur above
};

struct Arriving {
  Vec3 to_light;  // unit
  Vec3 radiance;
};

// (1 - d^2)^(n/2). Near d = 0 the series of the logarithm keeps the digits that 1 - d^2 loses.
FUNCTION Real sine_power(Real d, Real n) {
  Real x = d * d;
  Real series = -x * (1.0f + x * (0.5f + x * (0.33333333f + x * (0.25f + x * (0.2f + x * 0.16666667f)))));
  Real rest = max(1.0f - x, 1e-12f);
  Real power = exp(0.5f * n * select(x < 0.08f, series, log(rest)));
  return select(x >= 1.0f, select(n > 0.0f, 0.0f, 1.0f), power);
}

FUNCTION Real sine_to(Real cosine) { return sqrt(max(1.0f - cosine * cosine, 0.0f)); }

FUNCTION Vec3 unit_or_zero(Vec3 v) { return v * (1.0f / sqrt(max(dot(v, v), 1e-12f))); }

FUNCTION Real scheuermann_lobe(Real along, Real n) { return smoothstep(-1.0f, 0.0f, along) * sine_power(along, n); }

// exp(-x) I0(x) for x >= 0, within 4e-4 of itself: its square's inverse is 1 + 2 x near 0 and 2 pi x far out, and a ratio
// of polynomials between (a least squares fit of ours). No branch and no exponential, unlike Abramowitz and Stegun 9.8.1.
FUNCTION Real scaled_bessel_i0(Real x) {
  Real over = 1.0f + x * (2.37362723f + x * (2.65343988f + x * (1.1803919f + x * 1.1000664f)));
  Real under = 1.0f + x * (0.38860871f + x * (0.23850039f + x * 0.17503195f));
  return sqrt(under / over);
}

// One lobe of Mp of d'Eon 2011. Sines of the inclinations are about the axis from tip to root.
FUNCTION Real longitudinal_lobe(Real sine_light, FibreEye eye, float tilt_sine, float tilt_cosine, float over_variance,
                                float normaliser) {
  Real cosine_light = sine_to(sine_light);
  Real tilted_sine = eye.sine * tilt_cosine + eye.cosine * tilt_sine;
  Real tilted_cosine = abs(eye.cosine * tilt_cosine - eye.sine * tilt_sine);
  Real apart = cosine_light - tilted_cosine, sum = sine_light + tilted_sine;
  Real fall = exp(-0.5f * (apart * apart + sum * sum) * over_variance) * normaliser;
  return fall * scaled_bessel_i0(cosine_light * tilted_cosine * over_variance);
}

// Angle of that sine, radians: by the half angle, whose tangent lies in [-1, 1].
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

// cos theta_d, half the difference of two inclinations, by their sines: its square is (1 + cos(2 theta_d)) / 2.
FUNCTION Real cos_half_difference(Real sine_light, Real sine_view) {
  Real whole = sine_to(sine_light) * sine_to(sine_view) + sine_light * sine_view;
  return sqrt(max(0.5f + 0.5f * whole, 0.0f));
}

// One lobe of M of Marschner 2003 over cos^2 theta_d.
FUNCTION Real marschner_lobe(Real middle, Real cos_difference, float centre, float over_variance, float normaliser) {
  Real apart = middle - centre;
  return exp(-0.5f * apart * apart * over_variance) * normaliser / max(cos_difference * cos_difference, 1e-3f);
}

// |phi| between light and view around the strand as azimuth_coordinate of scattering_table.h has it, by the perimeter of a
// square: no arc tangent. Along the strand there is none: the middle of the range then.
FUNCTION Real azimuth_between(Vec3 tangent, Vec3 aside, Vec3 to_light) {
  Vec3 light = to_light - tangent * dot(tangent, to_light);
  Real x = dot(aside, light), perimeter = abs(x) + abs(dot(tangent, cross(aside, light)));
  return select(perimeter > 1e-10f, 0.5f - 0.5f * x / max(perimeter, 1e-10f), 0.5f);
}

FUNCTION bool scatters_fibres(int model) { return model == model_energy_conserving || model == model_marschner; }

// B of GPU fur eq 1: models that know about light from behind keep all of it.
FUNCTION Real light_behind(int model, Real facing, float reach) {
  bool surface = model == model_lengyel || model == model_kajiya || model == model_kajiya_kay;
  if (!surface) return Real(1.0f);
  return select(facing < 0.0f, 1.0f - min(-facing, reach) / max(reach, 1e-20f), 1.0f);
}

// Returns how far a ray goes through the fur to get out of it, over the height above its start: the lower it points,
// the further. From a height h below the tips, over a body of radius r, that is h 2 / (n.d + sqrt((n.d)^2 + 2 h / r)).
FUNCTION Real way_out(Real height, Real facing) {
  Real roundness = 0.2f * (1.0f - height) + 0.01f;  // 2 h / r, where fur is a tenth of the radius of what it grows on
  return 2.0f / (facing + sqrt(facing * facing + roundness));
}

// Returns how many strands a ray crosses on its way out, if one at 45 degrees to upright fur would cross `above`. The
// number of hits is proportional to the sine of the ray's angle to the strands.
FUNCTION Real strands_crossed(Real above, Real way, Vec3 tangent, Vec3 direction) {
  float spread = 0.08f;  // strands of one place differ in direction
  Real along = dot(tangent, direction);
  return above * sqrt(1.0f - (1.0f - spread) * min(along * along, 1.0f)) * way;
}

// Strands on the way to the light less those that are met for sure, as the eye looks past them: the hot spot of leaf canopies
// (Kuusk 1985, "The hot spot effect of a uniform vegetative cover"). Of N to the camera and M to the light, rays that move
// apart by d widths of a strand share sqrt(N M) (1 - exp(-x)) / x, x = d / c; they may move apart along the strands. c would be
// 1/2 for any place in the fur. What one sees stands out of what is around it: 1/6 gives furry balls strands' light, within
// .03 from the side and from above, lying and upright.
FUNCTION Real strands_not_shared(Fibre fibre, FibreView view, Vec3 to_light, Real way, Real strands) {
  Vec3 apart = fibre.to_camera * view.way - to_light * way;
  apart = apart - dot(apart, fibre.tangent) * fibre.tangent;
  Real x = 6.0f * view.widths * length(apart);
  Real share = (1.0f + x * 0.16666667f) / (1.0f + x * (0.66666667f + x * 0.16666667f));  // (1 - exp(-x)) / x within .02
  return max(strands - sqrt(max(view.strands * strands, 0.0f)) * share, 0.0f);
}
