// The vertices of all shells: where fur has grown to at each height, and what a ray that meets it there has to know.
// The twin of renderer/passes/fur/fur_vertex.glsl.
#if defined(PELAGE_MARCHED_VERTICES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_VERTICES_INL_H_
#undef PELAGE_MARCHED_VERTICES_INL_H_
#else
#define PELAGE_MARCHED_VERTICES_INL_H_
#endif

#include <hwy/contrib/math/math-inl.h>

#include <algorithm>

#include "renderer/marched/march_scene.h"
#include "renderer/optics/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

HWY_INLINE Real sine(Real x) { return hn::Sin(float_tag, x.v); }
HWY_INLINE Real cosine(Real x) { return hn::Cos(float_tag, x.v); }

/// Along the lean and up the normal for a strand of length 1, and its angle to the normal (protocol/base/lean_curve.h).
struct LeanPlace {
  Real across, up, angle;
};

HWY_INLINE LeanPlace lean_arc(Real a0, Real a, float s) {
  const Real x = a * s, half = 0.5f * x;
  const Real sinc = select(abs(half) < 1e-2f, 1.0f - half * half * (1.0f / 6), sine(half) / max(abs(half), 1e-6f));
  const Real chord = s * sinc;
  return {chord * sine(a0 + half), chord * cosine(a0 + half), a0 + x};
}

HWY_INLINE Real parabola_length(Real u) {
  const Real root = sqrt(1.0f + u * u);
  return root + select(u < 1e-2f, 1.0f - u * u * (1.0f / 6), log(u + root) / max(u, 1e-6f));
}

HWY_INLINE LeanPlace lean_root(Real a0, Real a, float s) {
  const Real half = 0.5f * a, u1 = 2.0f * sine(half) / max(cosine(half), 1e-6f), whole = parabola_length(u1);
  Real r = s;
  for (int i = 0; i < 3; ++i) {
    const Real u = r * u1;
    r -= (r * parabola_length(u) - s * whole) / (2.0f * sqrt(1.0f + u * u));
  }
  const Real y = 2.0f * r / whole, x = r * r * u1 / whole;
  return {y * sine(a0) + x * cosine(a0), y * cosine(a0) - x * sine(a0), a0 + Real(hn::Atan(float_tag, (r * u1).v))};
}

/// Vertices side by side, `lane_count` of them; the last ones again past the end.
struct VertexBlock {
  std::size_t index[lane_count];
  int count;

  template <class Get>
  HWY_INLINE Real read(Get get) const {
    float values[lane_count];
    for (int i = 0; i < lane_count; ++i) values[i] = get(index[i]);
    return load(values);
  }
  template <class Array>
  HWY_INLINE Vec3 vec3(const Array& array) const {
    return {read([&](std::size_t i) { return array[i].x; }), read([&](std::size_t i) { return array[i].y; }),
            read([&](std::size_t i) { return array[i].z; })};
  }
};

/// Numbers of a block that go to the vertices' rows.
struct VertexWriter {
  MarchScene& scene;
  const VertexBlock& block;
  int shell;

  HWY_INLINE void row(int at, Real value) const {
    float values[lane_count];
    store(value, values);
    for (int i = 0; i < block.count; ++i) scene.row(scene.row_of(shell, block.index[i]))[at] = values[i];
  }
  HWY_INLINE void rows(int at, Vec3 value) const { row(at, value.x), row(at + 1, value.y), row(at + 2, value.z); }
};

/// What of a block's strands is the same at all heights.
struct VertexStrand {
  Vec3 root, normal, lean;
  Vec3 shading_normal;
  Real length, inclination, share;
  Real hull_length, hull_inclination;  // without a pattern, which does not change the hull
};

HWY_INLINE VertexStrand strand_of(const MarchScene& scene, const VertexBlock& block) {
  const MarchMesh& mesh = scene.mesh;
  VertexStrand strand;
  strand.root = block.vec3(mesh.positions), strand.normal = block.vec3(mesh.normals);
  strand.shading_normal = block.vec3(mesh.shading_normals);
  const Vec3 tangent = block.vec3(mesh.tangents), groom = block.vec3(mesh.groom);
  const Real size = sqrt(groom.x * groom.x + groom.y * groom.y), inclination = min(size, 1.0f);
  const Real over = 1.0f / max(inclination, 1e-6f);
  const Mask leans = inclination > 1e-6f;
  strand.lean = tangent * select(leans, groom.x * over, 1.0f) +
                cross(strand.normal, tangent) * select(leans, groom.y * over, 0.0f);
  strand.length = strand.hull_length = groom.z, strand.inclination = strand.hull_inclination = inclination;
  // Fur of no length is no fur, or it would lie as a fog on bare skin.
  strand.share = block.read([&](std::size_t i) { return mesh.weights[i]; }) * smoothstep(0.0f, 0.002f, groom.z);
  if (mesh.variation.empty()) return strand;
  strand.length *= block.read([&](std::size_t i) { return mesh.variation[i].x; });
  strand.inclination = clamp(inclination + block.read([&](std::size_t i) { return mesh.variation[i].y; }), 0.0f, 1.0f);
  return strand;
}

/// Rows that are the same at all heights, times a factor.
HWY_INLINE void write_fields(const VertexWriter& to, const VertexStrand& strand, Real factor) {
  const MarchMesh& mesh = to.scene.mesh;
  const Varyings& at = to.scene.varyings;
  const VertexBlock& block = to.block;
  const Real tile = to.scene.optics.frame.tile.x * factor;
  to.row(Varyings::tile, tile * block.read([&](std::size_t i) { return mesh.tiles[i].x; }));
  to.row(Varyings::tile + 1, tile * block.read([&](std::size_t i) { return mesh.tiles[i].y; }));
  to.rows(Varyings::normal, strand.shading_normal * factor);
  to.row(Varyings::length, strand.length * factor);
  to.row(Varyings::share, strand.share * factor);
  if (at.root >= 0) to.rows(at.root, strand.root * factor);
  if (at.varied >= 0) {
    to.row(at.varied, factor * block.read([&](std::size_t i) { return mesh.variation[i].z; }));
    to.row(at.varied + 1, factor * block.read([&](std::size_t i) { return mesh.variation[i].w; }));
  }
  if (at.image >= 0) {
    to.rows(at.image, block.vec3(mesh.image_uvs) * factor);
    to.rows(at.image + 3, block.vec3(mesh.colours) * factor);
  }
  for (int k = 0; at.paint >= 0 && k < 6; ++k)
    to.row(at.paint + k,
           factor * block.read([&](std::size_t i) { return mesh.paint[i][static_cast<std::size_t>(k)]; }));
  for (int k = 0; at.painted >= 0 && k < 8; ++k)
    to.row(at.painted + k,
           factor * block.read([&](std::size_t i) { return mesh.painted[i][static_cast<std::size_t>(k)]; }));
}

HWY_INLINE LeanPlace lean_place(const MarchScene& scene, Real inclination, float s) {
  const Real tip = inclination * 1.57079633f, a0 = scene.optics.frame.counts.w * tip;
  return scene.optics.frame.tile.z > 0.5f ? lean_root(a0, tip - a0, s) : lean_arc(a0, tip - a0, s);
}

/// Where light from other parts of the body comes to fur at a height `s`: at or above the hull (hull_offset of
/// lean.glsl). Times a factor.
HWY_INLINE void write_open(const VertexWriter& to, const VertexStrand& strand, float s, Real factor) {
  const LeanPlace curve = lean_place(to.scene, strand.hull_inclination, std::max(s, hull_height));
  const Vec3 open = strand.root + strand.hull_length * (curve.across * strand.lean + curve.up * strand.normal);
  to.rows(to.scene.varyings.open, open * factor);
  to.row(to.scene.varyings.open + 3, hull_height * strand.hull_length * factor);
}

HWY_INLINE void write_vertex(const VertexWriter& to, const VertexStrand& strand, float s) {
  const MarchScene& scene = to.scene;
  const LeanPlace curve = lean_place(scene, strand.inclination, s);
  const Vec3 place = strand.root + strand.length * (curve.across * strand.lean + curve.up * strand.normal);
  to.rows(Varyings::place, place);
  const glm::mat4& m = scene.optics.frame.world_to_clip;
  const auto clip = [&](int row) HWY_ATTR {
    return mul_add(place.x, m[0][row], mul_add(place.y, m[1][row], mul_add(place.z, m[2][row], m[3][row])));
  };
  const Real distance = clip(3);
  const Mask before = distance > near_distance;
  const Real inverse = select(before, 1.0f / max(distance, near_distance), 0.0f),
             factor = select(before, inverse, 1.0f);
  to.row(Varyings::x, (clip(0) * inverse * 0.5f + 0.5f) * static_cast<float>(scene.width));
  to.row(Varyings::y, (0.5f - clip(1) * inverse * 0.5f) * static_cast<float>(scene.height));
  to.rows(Varyings::tangent, (strand.lean * sine(curve.angle) + strand.normal * cosine(curve.angle)) * factor);
  to.row(Varyings::inverse, inverse);
  write_fields(to, strand, factor);
  if (scene.varyings.open >= 0) write_open(to, strand, s, factor);
}

/// All shells of the vertices [begin, end).
HWY_INLINE void place_vertices(MarchScene& scene, std::size_t begin, std::size_t end) {
  for (std::size_t first = begin; first < end; first += static_cast<std::size_t>(lane_count)) {
    VertexBlock block;
    block.count = static_cast<int>(std::min<std::size_t>(end - first, static_cast<std::size_t>(lane_count)));
    for (int i = 0; i < lane_count; ++i)
      block.index[i] = first + static_cast<std::size_t>(std::min(i, block.count - 1));
    const VertexStrand strand = strand_of(scene, block);
    for (int shell = 0; shell < scene.shells.count(); ++shell)
      write_vertex({scene, block, shell}, strand, scene.shells.heights[static_cast<std::size_t>(shell)]);
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
