// Guided curves among the fur of a tile: each pixel of a ribbon is lit when it is rasterized and blended where it lies.
#if defined(PELAGE_MARCHED_CURVES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_MARCHED_CURVES_INL_H_
#undef PELAGE_MARCHED_CURVES_INL_H_
#else
#define PELAGE_MARCHED_CURVES_INL_H_
#endif

#include <bit>

#include "renderer/marched/march-inl.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

/// Where a group's pixels lie on a ribbon (on_ribbon of ribbons.h).
struct LanesOnRibbon {
  Mask there;
  Real share;  // from root to tip
  Real opacity;
};

HWY_INLINE LanesOnRibbon lanes_on_ribbon(const Ribbon& ribbon, Real px, Real py) {
  const RibbonEnd &a = ribbon.root, &b = ribbon.tip;
  const Real from_root = (px - a.at.x) * a.along.x + (py - a.at.y) * a.along.y;
  const Real past_tip = (px - b.at.x) * b.along.x + (py - b.at.y) * b.along.y;
  const Mask between = (from_root >= 0.0f) & (past_tip < 0.0f);
  const Real share = clamp(from_root / max(from_root - past_tip, 1e-12f), 0.0f, 1.0f);
  const glm::vec2 way = b.at - a.at;
  const float over_length = 1 / std::max(glm::length(way), 1e-12f);
  const Real across = abs((px - a.at.x) * way.y - (py - a.at.y) * way.x) * over_length;
  const Real opacity = mix(Real(a.strength), Real(b.strength), share) *
                       clamp(mix(Real(a.reach), Real(b.reach), share) + 0.5f - across, 0.0f, 1.0f);
  return {between & (opacity > 0.004f), share, opacity};
}

/// A curve is lit as a strand at the tips of the fur that it grows from: nothing stands above it.
HWY_INLINE Fibre ribbon_fibre(const MarchScene& scene, const Ribbon& ribbon, Real share) {
  const RibbonEnd &a = ribbon.root, &b = ribbon.tip;
  Fibre fibre;
  fibre.place = mix(Vec3(a.place), Vec3(b.place), share);
  fibre.normal = Vec3(ribbon.normal), fibre.tangent = unit(mix(Vec3(a.tangent), Vec3(b.tangent), share));
  fibre.to_camera = unit(Vec3(scene.viewpoint) - fibre.place);
  fibre.colour = mix(Vec3(a.colour), Vec3(b.colour), share), fibre.crossed = colour_above(scene.optics.frame, 1.0f);
  fibre.height = 1.0f, fibre.above = 0.0f, fibre.strand = ribbon.number;
  fibre.shine = {1.0f, 1.0f};
  fibre.open = fibre.place, fibre.hull = 0.0f;
  return fibre;
}

/// What a vertex of the skin has in a row, mixed at the root of a hair.
HWY_INLINE Real at_hair_root(const MarchScene& scene, const HairRoot& hair, int at) {
  float sum = 0;
  for (int k = 0; k < 3; ++k) {
    const float* row = scene.row(scene.row_of(0, hair.corners[k]));
    const float inverse = row[Varyings::inverse];
    sum += hair.weights[k] * (inverse > 0 ? row[at] / inverse : row[at]);
  }
  return sum;
}

/// A guard hair is lit as the strand of its coat that it is, by the fur above its height.
HWY_INLINE Fibre hair_fibre(const MarchScene& scene, const Ribbon& ribbon, Real share) {
  const FrameOptics& optics = scene.optics;
  const HairRoot& hair = scene.hairs[static_cast<std::size_t>(ribbon.hair)];
  const auto row = [&](int at) HWY_ATTR { return at_hair_root(scene, hair, at); };
  const auto rows = [&](int at) HWY_ATTR { return Vec3(row(at), row(at + 1), row(at + 2)); };
  Fibre fibre = ribbon_fibre(scene, ribbon, share);
  fibre.height = mix(Real(ribbon.root.height), Real(ribbon.tip.height), share);
  const Int slice = to_int(clamp(fibre.height * static_cast<float>(slice_count), 0.0f, slice_count - 1.0f));
  fibre.above =
      gather(&optics.frame.depth_above[0].x, slice) * row(Varyings::length) * static_cast<float>(1 / nominal_length);
  fibre.colour = strand_colour(optics, scene.varyings, fibre.colour, row, rows, 0.0f);
  Cover above{Vec3(0.0f), 0.0f};
  if (optics.paint.colour) {
    const PaintedColours paint = painted_colours(scene.varyings, row, rows);
    fibre.colour = covered_by(cover_at(paint, fibre.height), fibre.colour, 1.0f);
    above = cover_at(paint, 0.5f * (fibre.height + 1.0f));
  }
  if (optics.paint.form) {
    const PaintedFields fields = painted_fields(scene.varyings, row);
    fibre.above *= fields.depth();
    fibre.colour = colour_wetted(optics.paint, fields.wetness, fibre.colour);
    fibre.shine = shine_of(optics.paint, fields.wetness);
  }
  fibre.crossed = covered_by(above, fibre.colour * colour_above(optics.frame, fibre.height), 1.0f);
  return fibre;
}

/// What AOVs keep of each lane that is there.
HWY_INLINE void keep_ribbon_aovs(const Fibre& fibre, const Direct& direct, Real inverse, Mask there,
                                 std::vector<AovPixel>& aovs) {
  AovSums sums;
  sums.add({fibre.place, fibre.normal, fibre.tangent, fibre.colour, direct, 0.0f, inverse}, 1.0f, 1.0f);
  for (std::uint32_t lanes = bits_of(there); lanes != 0; lanes &= lanes - 1) {
    AovPixel& pixel = aovs.emplace_back();
    for (int row = 0; row < AovRows::count; ++row)
      pixel[static_cast<std::size_t>(row)] = sums.at(row, std::countr_zero(lanes));
  }
}

HWY_INLINE void raster_ribbon(const MarchScene& scene, const Ribbon& ribbon, int group, Real px, Real py,
                              bool keeps_aovs, TileScratch& scratch) {
  LanesOnRibbon on = lanes_on_ribbon(ribbon, px, py);
  if (!any(on.there)) return;
  const Real inverse = mix(Real(ribbon.root.inverse), Real(ribbon.tip.inverse), on.share);
  on.there = on.there & (inverse >= load(scratch.nearest() + group * lane_count));
  if (!any(on.there)) return;
  const Fibre fibre = ribbon.hair < 0 ? ribbon_fibre(scene, ribbon, on.share) : hair_fibre(scene, ribbon, on.share);
  Direct direct = Direct::none();
  const Vec3 light = fibre_light(scene.optics, fibre, keeps_aovs ? &direct : nullptr) * on.opacity;
  auto kept = static_cast<std::uint32_t>(scratch.curves.aovs.size());
  if (keeps_aovs) keep_ribbon_aovs(fibre, direct, inverse, on.there, scratch.curves.aovs);
  float numbers[5][lane_count];
  store(inverse, numbers[0]), store(light.x, numbers[1]), store(light.y, numbers[2]), store(light.z, numbers[3]);
  store(on.opacity, numbers[4]);
  for (std::uint32_t lanes = bits_of(on.there); lanes != 0; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    scratch.curves.pixels.push_back(
        {group * lane_count + i, numbers[0][i], {numbers[1][i], numbers[2][i], numbers[3][i], numbers[4][i]}, kept++});
  }
}

/// After the skin and the eyes, which hide what lies behind them.
HWY_INLINE void raster_curves(const MarchScene& scene, const Tile& tile, bool keeps_aovs, TileScratch& scratch) {
  scratch.curves.pixels.clear(), scratch.curves.aovs.clear();
  for (const std::uint32_t number : scene.ribbons.of_tile(tile.number)) {
    const Ribbon& ribbon = scene.ribbons[number];
    const float reach = std::max(ribbon.root.reach, ribbon.tip.reach) + 1.5f;
    const glm::vec2 low = glm::min(ribbon.root.at, ribbon.tip.at) - reach,
                    high = glm::max(ribbon.root.at, ribbon.tip.at) + reach;
    for (int group = 0; group < groups_across * groups_down; ++group) {
      const int left = tile.left + group % groups_across * group_width,
                top = tile.top + group / groups_across * group_height;
      const bool apart = high.x < static_cast<float>(left) || high.y < static_cast<float>(top) ||
                         low.x > static_cast<float>(left + group_width) ||
                         low.y > static_cast<float>(top + group_height);
      if (!apart)
        raster_ribbon(scene, ribbon, group, lanes_x() + static_cast<float>(left), lanes_y() + static_cast<float>(top),
                      keeps_aovs, scratch);
    }
  }
  scratch.curves.sort();
}

/// Blends the curves of a group that lie before `until` (1 / distance) and were not blended yet.
HWY_INLINE void see_curves(const TileScratch& scratch, int group, const float* until, std::uint32_t* next, Seen& seen) {
  float r[lane_count], g[lane_count], b[lane_count], through[lane_count];
  store(seen.light.x, r), store(seen.light.y, g), store(seen.light.z, b), store(seen.through, through);
  for (int i = 0; i < lane_count; ++i) {
    const std::uint32_t end = scratch.curves.first[static_cast<std::size_t>(group * lane_count + i) + 1];
    for (; next[i] < end && scratch.curves.pixels[next[i]].inverse >= until[i]; ++next[i]) {
      const glm::vec4& light = scratch.curves.pixels[next[i]].light;
      if (seen.aovs)
        seen.aovs->add(i, scratch.curves.aovs[scratch.curves.pixels[next[i]].aovs], through[i] * light.a, through[i]);
      r[i] += through[i] * light.r, g[i] += through[i] * light.g, b[i] += through[i] * light.b;
      through[i] -= through[i] * light.a;
    }
  }
  seen.light = {load(r), load(g), load(b)}, seen.through = load(through);
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
