// SIMD numbers, with one pixel for each lane, and small vectors of them. This file is included once for each
// instruction set by Highway (hwy/foreach_target.h); everything lies inside the namespace of that set.
#if defined(PELAGE_OPTICS_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_OPTICS_LANES_INL_H_
#undef PELAGE_OPTICS_LANES_INL_H_
#else
#define PELAGE_OPTICS_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>
#include <glm/glm.hpp>

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::ScalableTag<std::int32_t>;
inline constexpr FloatTag float_tag;
inline constexpr IntTag int_tag;
inline constexpr int lane_count = static_cast<int>(HWY_LANES(float));

/// A boolean for each lane.
struct Mask {
  hn::Mask<FloatTag> m;
};
HWY_INLINE Mask operator&(Mask a, Mask b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE Mask operator|(Mask a, Mask b) { return {hn::Or(a.m, b.m)}; }
HWY_INLINE bool any(Mask a) { return !hn::AllFalse(float_tag, a.m); }
HWY_INLINE bool any_lane(Mask a) { return any(a); }
HWY_INLINE Mask both(Mask a, Mask b) { return a & b; }
HWY_INLINE Mask either(Mask a, Mask b) { return a | b; }
HWY_INLINE bool all(Mask a) { return hn::AllTrue(float_tag, a.m); }
/// Returns the mask as bits: lane i is bit i.
HWY_INLINE std::uint32_t bits_of(Mask a) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(float_tag, a.m, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// One number for each lane.
struct Real {
  hn::Vec<FloatTag> v;
  Real() = default;
  HWY_INLINE Real(float value) : v(hn::Set(float_tag, value)) {}  // NOLINT: as numbers are written in formulas
  HWY_INLINE Real(hn::Vec<FloatTag> value) : v(value) {}          // NOLINT
};
HWY_INLINE Real operator+(Real a, Real b) { return hn::Add(a.v, b.v); }
HWY_INLINE Real operator-(Real a, Real b) { return hn::Sub(a.v, b.v); }
HWY_INLINE Real operator*(Real a, Real b) { return hn::Mul(a.v, b.v); }
HWY_INLINE Real operator/(Real a, Real b) { return hn::Div(a.v, b.v); }
HWY_INLINE Real operator-(Real a) { return hn::Neg(a.v); }
HWY_INLINE Real& operator+=(Real& a, Real b) { return a = a + b; }
HWY_INLINE Real& operator*=(Real& a, Real b) { return a = a * b; }
HWY_INLINE Mask operator<(Real a, Real b) { return {hn::Lt(a.v, b.v)}; }
HWY_INLINE Mask operator>(Real a, Real b) { return {hn::Gt(a.v, b.v)}; }
HWY_INLINE Mask operator<=(Real a, Real b) { return {hn::Le(a.v, b.v)}; }
HWY_INLINE Mask operator>=(Real a, Real b) { return {hn::Ge(a.v, b.v)}; }
/// Returns a b + c, rounded once if the CPU has FMA.
HWY_INLINE Real mul_add(Real a, Real b, Real c) { return hn::MulAdd(a.v, b.v, c.v); }
HWY_INLINE Real min(Real a, Real b) { return hn::Min(a.v, b.v); }
HWY_INLINE Real max(Real a, Real b) { return hn::Max(a.v, b.v); }
HWY_INLINE Real abs(Real a) { return hn::Abs(a.v); }
HWY_INLINE Real sqrt(Real a) { return hn::Sqrt(a.v); }
HWY_INLINE Real floor(Real a) { return hn::Floor(a.v); }
HWY_INLINE Real clamp(Real a, Real low, Real high) { return min(max(a, low), high); }
HWY_INLINE Real select(Mask mask, Real yes, Real no) { return hn::IfThenElse(mask.m, yes.v, no.v); }
HWY_INLINE Real mix(Real a, Real b, Real share) { return mul_add(share, b - a, a); }
/// For values that are the same in all lanes.
HWY_INLINE float max(float a, float b) { return a > b ? a : b; }
HWY_INLINE float clamp(float a, float low, float high) { return a < low ? low : a > high ? high : a; }
HWY_INLINE Real load(const float* from) { return hn::LoadU(float_tag, from); }
HWY_INLINE void store(Real value, float* to) { hn::StoreU(value.v, float_tag, to); }
HWY_INLINE Real smoothstep(Real low, Real high, Real x) {
  const Real t = clamp((x - low) / (high - low), 0.0f, 1.0f);
  return t * t * (3.0f - 2.0f * t);
}

/// Integers, for indices into arrays.
using Int = hn::Vec<IntTag>;
HWY_INLINE Int to_int(Real a) { return hn::ConvertTo(int_tag, a.v); }  // rounds towards 0
HWY_INLINE Real to_real(Int a) { return hn::ConvertTo(float_tag, a); }
HWY_INLINE Int splat(std::int32_t a) { return hn::Set(int_tag, a); }
HWY_INLINE Real gather(const float* from, Int index) { return hn::GatherIndex(float_tag, from, index); }
HWY_INLINE Int gather(const std::int32_t* from, Int index) { return hn::GatherIndex(int_tag, from, index); }
/// Four adjacent words for each lane, read by loads and shuffles, which are faster than four gathers.
struct Quad {
  Int word[4];
  HWY_INLINE Real real(int k) const { return hn::BitCast(float_tag, word[k]); }
};

/// Loads the four words of every fourth lane, starting with the first one of `index`.
template <class Tag>
HWY_INLINE hn::Vec<Tag> load_every_fourth(Tag tag, const std::int32_t* from, const std::int32_t* index) {
  if constexpr (hn::MaxLanes(Tag()) == 4) {
    return hn::LoadU(tag, from + *index);
  } else {
    const hn::Half<Tag> half;
    return hn::Combine(tag, load_every_fourth(half, from, index + hn::MaxLanes(Tag()) / 2),
                       load_every_fourth(half, from, index));
  }
}

/// Loads the four words from `index` on for each lane.
HWY_INLINE Quad gather_quad(const std::int32_t* from, Int index) {
  HWY_ALIGN std::int32_t at[lane_count];
  hn::Store(index, int_tag, at);
  // Each row has the words of one lane from each block of four lanes. Not a loop, because compilers keep it as one and
  // go through memory.
  const Int row[4] = {load_every_fourth(int_tag, from, at), load_every_fourth(int_tag, from, at + 1),
                      load_every_fourth(int_tag, from, at + 2), load_every_fourth(int_tag, from, at + 3)};
  const hn::Repartition<std::int64_t, IntTag> pair_tag;
  const auto low = [&](Int a, Int b) HWY_ATTR { return hn::BitCast(pair_tag, hn::InterleaveLower(int_tag, a, b)); };
  const auto high = [&](Int a, Int b) HWY_ATTR { return hn::BitCast(pair_tag, hn::InterleaveUpper(int_tag, a, b)); };
  const auto first = low(row[0], row[1]), second = low(row[2], row[3]);
  const auto third = high(row[0], row[1]), fourth = high(row[2], row[3]);
  return {{hn::BitCast(int_tag, hn::InterleaveLower(pair_tag, first, second)),
           hn::BitCast(int_tag, hn::InterleaveUpper(pair_tag, first, second)),
           hn::BitCast(int_tag, hn::InterleaveLower(pair_tag, third, fourth)),
           hn::BitCast(int_tag, hn::InterleaveUpper(pair_tag, third, fourth))}};
}
HWY_INLINE Quad gather_quad(const float* from, Int index) {
  return gather_quad(reinterpret_cast<const std::int32_t*>(from), index);
}

/// Returns a byte of each lane, over 255.
template <int at>
HWY_INLINE Real byte_of(Int word) {
  return to_real(hn::And(hn::ShiftRight<8 * at>(word), splat(255))) * (1.0f / 255);
}

/// Returns 2^x; 0 for x below -126, 2^126 for x above 126. Relative error 2e-7: least-squares polynomial for the
/// fraction.
HWY_INLINE Real exp2(Real x) {
  const Real clamped = clamp(x, -127.0f, 126.0f);
  const Real below = floor(clamped), part = clamped - below;
  Real p = 1.8762329e-3f;
  p = mul_add(p, part, 8.9925844e-3f);
  p = mul_add(p, part, 5.5823606e-2f);
  p = mul_add(p, part, 2.4015453e-1f);
  p = mul_add(p, part, 6.9315296e-1f);
  p = mul_add(p, part, 9.9999994e-1f);
  const Int power = hn::ShiftLeft<23>(hn::Add(to_int(below), splat(127)));
  return p * Real(hn::BitCast(float_tag, power));
}
HWY_INLINE Real exp(Real x) { return exp2(x * 1.44269504f); }

/// Returns log2 of a normal x > 0. Absolute error 2e-7 near 1: 2 atanh((m - 1) / (m + 1)) / ln 2 for the mantissa in
/// [.71, 1.41].
HWY_INLINE Real log2(Real x) {
  const Int bits = hn::BitCast(int_tag, max(x, 1.1754944e-38f).v);
  const Int shifted = hn::Sub(bits, splat(0x3f3504f3));
  const Real power = to_real(hn::ShiftRight<23>(shifted));
  const Int mantissa = hn::Add(hn::And(shifted, splat(0x007fffff)), splat(0x3f3504f3));
  const Real m = hn::BitCast(float_tag, mantissa), t = (m - 1.0f) / (m + 1.0f), t2 = t * t;
  Real p = 0.43424776f;
  p = mul_add(p, t2, 0.57658499f);
  p = mul_add(p, t2, 0.96180075f);
  p = mul_add(p, t2, 2.8853900f);
  return mul_add(p, t, power);
}
HWY_INLINE Real log(Real x) { return log2(x) * 0.69314718f; }
/// Returns x^y for x >= 0.
HWY_INLINE Real pow(Real x, Real y) { return exp2(y * log2(x)); }

/// Angles with an error within 3e-8 radians (Abramowitz and Stegun 4.4.49 and 4.4.46).
HWY_INLINE Real atan2(Real y, Real x) {
  const Real across = abs(x), up = abs(y), t = min(across, up) / max(max(across, up), 1e-30f), t2 = t * t;
  Real p = 0.0028662257f;
  for (const float factor : {-0.0161657367f, 0.0429096138f, -0.0752896400f, 0.1065626393f, -0.1420889944f,
                             0.1999355085f, -0.3333314528f, 1.0f})
    p = mul_add(p, t2, factor);
  Real angle = p * t;
  angle = select(up > across, 1.57079633f - angle, angle);
  angle = select(x < 0.0f, 3.14159265f - angle, angle);
  return select(y < 0.0f, -angle, angle);
}
HWY_INLINE Real acos(Real cosine) {
  const Real x = min(abs(cosine), 1.0f);
  Real p = -0.0012624911f;
  for (const float factor :
       {0.0066700901f, -0.0170881256f, 0.0308918810f, -0.0501743046f, 0.0889789874f, -0.2145988016f, 1.5707963050f})
    p = mul_add(p, x, factor);
  const Real angle = p * sqrt(1.0f - x);
  return select(cosine < 0.0f, 3.14159265f - angle, angle);
}

struct Vec2 {
  Real x, y;
  Vec2() = default;
  HWY_INLINE Vec2(Real a, Real b) : x(a), y(b) {}
};
HWY_INLINE Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
HWY_INLINE Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
HWY_INLINE Vec2 operator*(Vec2 a, Real s) { return {a.x * s, a.y * s}; }
HWY_INLINE Real length(Vec2 a) { return sqrt(mul_add(a.x, a.x, a.y * a.y)); }

struct Vec3 {
  Real x, y, z;
  Vec3() = default;
  HWY_INLINE Vec3(Real a, Real b, Real c) : x(a), y(b), z(c) {}
  HWY_INLINE explicit Vec3(Real same) : x(same), y(same), z(same) {}
  HWY_INLINE Vec3(const glm::vec3& same) : x(same.x), y(same.y), z(same.z) {}           // NOLINT: the same in all lanes
  HWY_INLINE explicit Vec3(const glm::vec4& same) : x(same.x), y(same.y), z(same.z) {}  // drops w
};
HWY_INLINE Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
HWY_INLINE Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
HWY_INLINE Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
HWY_INLINE Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
HWY_INLINE Vec3 operator*(Vec3 a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
HWY_INLINE Vec3 operator*(Real s, Vec3 a) { return a * s; }
HWY_INLINE Vec3 operator/(Vec3 a, Vec3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
HWY_INLINE Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }
HWY_INLINE Vec3& operator*=(Vec3& a, Vec3 b) { return a = a * b; }
HWY_INLINE Real dot(Vec3 a, Vec3 b) { return mul_add(a.x, b.x, mul_add(a.y, b.y, a.z * b.z)); }
HWY_INLINE Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
HWY_INLINE Real length(Vec3 a) { return sqrt(dot(a, a)); }
/// Returns the unit vector, or 0 for a vector of length 0.
HWY_INLINE Vec3 unit(Vec3 a) { return a * (1.0f / max(length(a), 1e-20f)); }
HWY_INLINE Vec3 select(Mask mask, Vec3 yes, Vec3 no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
HWY_INLINE Vec3 mix(Vec3 a, Vec3 b, Real share) {
  return {mix(a.x, b.x, share), mix(a.y, b.y, share), mix(a.z, b.z, share)};
}
HWY_INLINE Vec3 mix(Vec3 a, Vec3 b, Vec3 share) {
  return {mix(a.x, b.x, share.x), mix(a.y, b.y, share.y), mix(a.z, b.z, share.z)};
}
/// Applies a function to each of the three components.
template <class Function>
HWY_INLINE Vec3 each(Vec3 a, Function function) {
  return {function(a.x), function(a.y), function(a.z)};
}
HWY_INLINE Vec3 max(Vec3 a, Real low) { return {max(a.x, low), max(a.y, low), max(a.z, low)}; }
HWY_INLINE Vec3 clamp(Vec3 a, Real low, Real high) {
  return {clamp(a.x, low, high), clamp(a.y, low, high), clamp(a.z, low, high)};
}
HWY_INLINE Vec3 sqrt(Vec3 a) { return {sqrt(a.x), sqrt(a.y), sqrt(a.z)}; }
HWY_INLINE Vec3 floor(Vec3 a) { return {floor(a.x), floor(a.y), floor(a.z)}; }
HWY_INLINE Vec3 exp2(Vec3 a) { return {exp2(a.x), exp2(a.y), exp2(a.z)}; }
HWY_INLINE Vec3 log2(Vec3 a) { return {log2(a.x), log2(a.y), log2(a.z)}; }
HWY_INLINE Real luminance(Vec3 linear) { return dot(linear, Vec3(0.2126f, 0.7152f, 0.0722f)); }

struct Vec4 {
  Real x, y, z, w;
  HWY_INLINE Vec4(Real a, Real b, Real c, Real d) : x(a), y(b), z(c), w(d) {}
};
HWY_INLINE Vec4 operator*(Real s, Vec4 a) { return {s * a.x, s * a.y, s * a.z, s * a.w}; }
HWY_INLINE Vec4& operator+=(Vec4& a, Vec4 b) { return a = {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
HWY_INLINE Vec4 mix(Vec4 a, Vec4 b, Real share) {
  return {mix(a.x, b.x, share), mix(a.y, b.y, share), mix(a.z, b.z, share), mix(a.w, b.w, share)};
}

/// The type of array indices in renderer/shaders/shared, which is compiled for SIMD lanes and as GLSL.
using Index = std::size_t;

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
