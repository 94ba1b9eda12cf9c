#include "tests/property/json/generators.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "protocol/json/colour.h"

namespace pelage::testing {

/// Draws numbers of every size within a range, its ends included.
double number(double low, double high) {
  const auto bits = *rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 53);
  const int kind = *rc::gen::inRange(0, 4);
  if (kind == 0) return low;
  if (kind == 1) return high;
  const double share = static_cast<double>(bits) * 0x1p-53;
  if (kind == 2) return low + (high - low) * share;
  return std::clamp(std::ldexp(share, -*rc::gen::inRange(0, 1000)), low, high);
}

static glm::dvec3 place() { return {number(-1e27, 1e27), number(-1e27, 1e27), number(-1e27, 1e27)}; }
glm::dvec3 direction() { return {number(-1e5, 1e5), number(1e-3, 1e5), number(-1e5, 1e5)}; }

glm::vec3 colour() {
  if (*rc::gen::arbitrary<bool>()) {
    const auto level = [] { return static_cast<unsigned>(*rc::gen::inRange(0, 256)); };
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", level(), level(), level());
    return *colour_of_text(text);
  }
  return {static_cast<float>(number(0, 1)), static_cast<float>(number(0, 1)), static_cast<float>(number(0, 1))};
}

Camera camera() {
  Camera result;
  result.automatic = one_of(AutoView::three_quarter);
  if (result.automatic != AutoView::none) return result;
  result.eye = {number(-10, 10), number(-10, 10), number(1, 10)};
  result.target = {number(-10, 10), number(-1, 1), number(-10, 0)};
  result.up = {0, number(0.1, 9), 0};
  result.fov_degrees = number(1, 150);
  return result;
}

static View view() { return {camera(), *rc::gen::inRange(1, 8193), *rc::gen::inRange(1, 8193)}; }

static StrokeSample sample() {
  StrokeSample result;
  switch (*rc::gen::inRange(0, 3)) {
    case 0: result.place = PositionPlace{place()}; break;
    case 1: result.place = ScreenPlace{{number(-1e6, 1e6), number(-1e6, 1e6)}}; break;
    default: {
      const double a = number(0, 1), b = number(0, 1 - a);
      result.place = SurfacePlace{*rc::gen::arbitrary<std::uint32_t>(), {a, b, std::max(0.0, 1 - a - b)}};
    }
  }
  result.pressure = number(0, 1);
  return result;
}

Stroke random_stroke() {
  Stroke result;
  result.id = *rc::gen::container<std::string>(*rc::gen::inRange(0, 20), rc::gen::inRange<char>(' ', '~'));
  result.part = *rc::gen::arbitrary<std::uint32_t>();
  result.last = *rc::gen::arbitrary<bool>();
  result.view = view();
  const int count = *rc::gen::inRange(1, 6);
  for (int i = 0; i < count; ++i) {
    result.samples.push_back(sample());
    result.samples.back().time = i + number(0, 0.5);
  }
  return result;
}

Brush random_brush() {
  return {.radius = number(0, 1e27),
          .units = one_of(RadiusUnits::pixels),
          .falloff_shape = one_of(FalloffShape::screen),
          .falloff = one_of(Falloff::sphere),
          .falloff_points = *rc::gen::arbitrary<bool>() ? std::vector{number(0, 1), number(0, 1)} : std::vector<double>{},
          .strength = number(0, 1),
          .spacing = number(0.01, 10),
          .pressure_to_radius = number(0, 1),
          .pressure_to_strength = number(0, 1),
          .front_faces_only = *rc::gen::arbitrary<bool>(),
          .cut_off_degrees = number(0, 180),
          .invert = *rc::gen::arbitrary<bool>(),
          .strand_from = number(0, 0.5),
          .strand_to = number(0.6, 1)};
}

static Undercoat undercoat() {
  return {.share = number(0, 1),
          .length = number(0.02, 1),
          .width = number(0.05, 4),
          .lightness = number(0, 4),
          .tint = number(0, 1),
          .colour = colour()};
}

static Pattern pattern() {
  return {.kind = one_of(PatternKind::countershading),
          .scale = number(0.005, 2),
          .coverage = number(0, 1),
          .contrast = number(0, 1),
          .softness = number(0, 1),
          .warp = number(0, 2),
          .legs = number(0, 1),
          .inner = number(0, 1),
          .belly = number(0, 1),
          .axis = direction(),
          .colour = colour(),
          .inner_colour = colour(),
          .belly_colour = colour(),
          .seed = *rc::gen::arbitrary<std::uint32_t>()};
}

static Variation variation() {
  return {.lightness = number(0, 1),
          .hue = number(0, 1),
          .length = number(0, 1),
          .lean = number(0, 1),
          .size = number(0.005, 2)};
}

Command set_coat() {
  Coat coat{.count = *rc::gen::inRange(1, 100001),
            .tile = number(0.01, 1),
            .width_root = number(0, 0.05),
            .width_tip = number(0, 0.05),
            .bend = number(0, 2),
            .curl = number(0, 0.5),
            .curl_turns = number(0, 20),
            .curl_together = number(0, 1),
            .wave = number(0, 0.5),
            .wave_turns = number(0, 20),
            .mess = number(0, 1),
            .clump = number(0, 1),
            .clump_size = number(0.001, 0.5),
            .fine_clump = number(0, 1),
            .fine_clump_size = number(0.001, 0.5),
            .lodge = number(0, 1),
            .lodge_size = number(0.001, 0.5),
            .wetness = number(0, 1),
            .length_spread = number(0, 1),
            .colour_spread = number(0, 1),
            .root_share = number(0, 1),
            .lean_curve = one_of(LeanCurve::root),
            .ramp = {},
            .undercoat = undercoat(),
            .odd_hairs = {.share = number(0, 1), .colour = colour()},
            .tufts = {.gather = number(0, 1),
                      .size = number(0.01, 1),
                      .scales = *rc::gen::inRange(1, 4),
                      .seed = *rc::gen::arbitrary<std::uint32_t>()},
            .pattern = pattern(),
            .variation = variation(),
            .seed = *rc::gen::arbitrary<std::uint32_t>()};
  const int stops = *rc::gen::inRange(1, 5);
  for (int i = 0; i < stops; ++i) coat.ramp.push_back({0.25 * i + number(0.01, 0.2), colour()});
  return SetCoat{coat};
}

Look look() {
  return {.shading = one_of(ShadingModel::marschner),
          .fibre = {.longitudinal_roughness = number(0, 1),
                    .azimuthal_roughness = number(0, 1),
                    .cuticle_tilt = number(-15, 15),
                    .refractive_index = number(1, 3),
                    .absorption = one_of(Absorption::melanin),
                    .eumelanin = number(0, 1e4),
                    .pheomelanin = number(0, 1e4),
                    .highlight_width = number(0, 90),
                    .caustic_width = number(1, 60),
                    .primary_shift = number(-2, 2),
                    .secondary_shift = number(-2, 2),
                    .shift_spread = number(0, 2),
                    .secondary_specular = number(0, 4),
                    .secondary_exponent = number(0, 1e6)},
          .colour_source = one_of(ColourSource::coat),
          .ambient = number(0, 4),
          .diffuse = number(0, 4),
          .specular = number(0, 4),
          .diffuse_exponent = number(0, 1e6),
          .specular_exponent = number(0, 1e6),
          .back_attenuation = number(1e-3, 1),
          .ambient_floor = number(0, 1),
          .self_shadow = number(0, 4),
          .skin = colour()};
}

Tracing tracing() {
  Tracing result{.passes = *rc::gen::inRange(1, 65'537),
                 .transport = one_of(Transport::paths),
                 .strands = *rc::gen::inRange(1, 8'000'001),
                 .noise = number(0, 1),
                 .seconds = number(0, 3600),
                 .filter = *rc::gen::arbitrary<bool>(),
                 .seed = *rc::gen::arbitrary<std::uint32_t>()};
  if (result.transport == Transport::paths) {
    result.scattering = StrandScattering::energy_conserving;
    result.bounces = *rc::gen::inRange(1, 4097);
  } else {
    result.scattering = one_of(StrandScattering::energy_conserving);
  }
  return result;
}

static Command set_lights() {
  SetLights result;
  const int count = *rc::gen::inRange(0, 9);
  for (int i = 0; i < count; ++i) {
    result.lights.push_back({.kind = one_of(LightKind::area),
                             .direction = direction(),
                             .position = place(),
                             .colour = colour(),
                             .intensity = number(0, 1e8),
                             .cone_degrees = number(0.1, 90),
                             .cone_softness = number(0, 1),
                             .angle_degrees = number(0, 90),
                             .radius = number(0, 10),
                             .width = number(1e-3, 100),
                             .height = number(1e-3, 100),
                             .self_shadow_maps = *rc::gen::arbitrary<bool>(),
                             .cast_shadow = one_of(CastShadow::penumbra),
                             .shadow_scale = number(0, 1000)});
  }
  return result;
}

static Command set_ground() {
  Ground ground{.visible = *rc::gen::arbitrary<bool>(), .height = {}, .shadow = number(0, 1), .contact = number(0, 1)};
  if (*rc::gen::arbitrary<bool>()) ground.height = number(-1e6, 1e6);
  return SetGround{ground};
}

static Command set_eyes() {
  SetEyes result;
  const int count = *rc::gen::inRange(0, 9);
  for (int i = 0; i < count; ++i) {
    Eye eye{.position = place(), .radius = number(1e-6, 1e6), .gaze = direction()};
    if (*rc::gen::arbitrary<bool>()) eye.look_at = {eye.position.x > 0 ? -1 : 1, number(-9, 9), 0};
    eye.iris = {.colour = colour(),
                .inner_colour = colour(),
                .size = number(0.1, 0.95),
                .depth = number(0, 0.5),
                .relief = number(0, 0.2),
                .limbal_ring = number(0, 1),
                .turn_degrees = number(-360, 360)};
    eye.pupil.shape = one_of(PupilShape::slit);
    if (*rc::gen::arbitrary<bool>()) eye.pupil.size = number(0, 1);
    if (*rc::gen::arbitrary<bool>()) {
      eye.lids = Lids{.facing = {},
                      .width_degrees = number(1, 90),
                      .upper_degrees = number(-90, 90),
                      .lower_degrees = number(-90, 90),
                      .tilt_degrees = number(-180, 180),
                      .colour = colour()};
      if (*rc::gen::arbitrary<bool>()) eye.lids->facing = direction();
    }
    eye.sclera = colour();
    eye.bulge = number(0, 1), eye.refraction = number(1, 3), eye.wetness = number(0, 1);
    result.eyes.push_back(eye);
  }
  return result;
}

static CurveGroup curve_group() {
  CurveGroup group{.curves = {},
                   .width_root = number(0, 0.1),
                   .width_tip = number(0, 0.1),
                   .root_colour = colour(),
                   .tip_colour = colour(),
                   .fill = *rc::gen::inRange(0, 100),
                   .spread = number(0, 1),
                   .seed = *rc::gen::arbitrary<std::uint32_t>()};
  const int count = *rc::gen::inRange(1, 3);
  for (int i = 0; i < count; ++i) {
    GuideCurve& curve = group.curves.emplace_back(*rc::gen::inRange<std::size_t>(2, 6));
    for (glm::dvec3& point : curve) point = place();
  }
  return group;
}

static Command set_curves() {
  SetCurves result;
  const int count = *rc::gen::inRange(0, 17);
  for (int i = 0; i < count; ++i) result.groups.push_back(curve_group());
  return result;
}

static Command set_skin() {
  SetSkin result;
  const int count = *rc::gen::inRange(0, 5);
  for (int i = 0; i < count; ++i) {
    SkinRegion region{.centre = place(), .radii = {number(1e-6, 1e6), number(1e-6, 1), number(1, 1e6)}};
    region.axis = direction();
    region.turn_degrees = number(-180, 180), region.softness = number(0, 10);
    if (*rc::gen::arbitrary<bool>()) region.facing = SkinFacing{direction(), number(0, 180), number(0, 180)};
    region.colour = colour();
    region.shine = number(0, 1), region.roughness = number(0.02, 1), region.wetness = number(0, 1);
    region.scatter = number(0, 1);
    region.bumps = {.height = number(0, 0.1), .size = number(1e-4, 1)};
    result.regions.push_back(region);
  }
  return result;
}

Command set_environment() {
  if (*rc::gen::arbitrary<bool>()) {
    return SetEnvironment{
        {.sky = colour(), .horizon = colour(), .ground = colour(), .harmonics = {}, .intensity = number(0, 100)}};
  }
  SphericalHarmonics harmonics;
  for (glm::dvec3& v : harmonics) v = {number(-1e6, 1e6), number(-1, 1), number(-1e6, 1e6)};
  Environment environment;
  environment.harmonics = harmonics;
  environment.turn_degrees = number(-360, 360), environment.intensity = number(0, 100);
  return SetEnvironment{environment};
}

Command set_base_picture() {
  if (*rc::gen::arbitrary<bool>()) return SetBasePicture{};
  return SetBasePicture{*rc::gen::container<std::string>(32, rc::gen::elementOf(std::string("0123456789abcdef")))};
}

Command command() {
  switch (*rc::gen::inRange(0, 18)) {
    case 0: return set_coat();
    case 1: return SetLook{look()};
    case 2: return set_environment();
    case 3: return set_ground();
    case 4: return set_eyes();
    case 5: return set_curves();
    case 6: return set_skin();
    case 7: return set_base_picture();
    case 8: return set_lights();
    default: return tool();
  }
}

}  // namespace pelage::testing
