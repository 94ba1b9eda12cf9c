// Projects strands onto the picture, one strand in each lane, and culls those that skin or fur hides.
#if defined(PELAGE_RASTER_PLACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef PELAGE_RASTER_PLACE_INL_H_
#undef PELAGE_RASTER_PLACE_INL_H_
#else
#define PELAGE_RASTER_PLACE_INL_H_
#endif

#include "renderer/coat/strand_tile.h"
#include "renderer/optics/light-inl.h"
#include "renderer/raster/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace pelage::HWY_NAMESPACE {

inline constexpr int max_knots = 64;

/// The projected knots of as many strands as there are lanes.
struct KnotLanes {
  HWY_ALIGN float x[max_knots][lane_count], y[max_knots][lane_count];
  HWY_ALIGN float inverse[max_knots][lane_count], half_width[max_knots][lane_count];
};

inline constexpr int root_stride = sizeof(StrandRoot) / sizeof(float);

HWY_INLINE Int strand_rows(const std::uint32_t* ids, int numbers) {
  return hn::Mul(hn::LoadU(int_tag, reinterpret_cast<const std::int32_t*>(ids)), splat(numbers));
}

/// Extent of strands on the picture, a strand a lane.
struct PlacedLanes {
  Real left, right, top, bottom;  // pixels
  Real nearest;                   // 1 / the smallest distance
  Real arc_length;                // length along the strand, pixels
  Real reach;                     // distance from its root to its tip on the picture, pixels
  Real longest;                   // length of its longest segment, pixels
  Real widest;                    // largest half width, pixels
  Real length;                    // length along the strand, sizes
  Vec3 root, tip;
};

HWY_INLINE PlacedLanes place_lanes(const PictureCamera& camera, const StrandSet& set, const std::uint32_t* ids,
                                   const float* widened, KnotLanes& knots) {
  const Int rows = strand_rows(ids, (set.segments + 1) * 4);
  const Real wider = load(widened) * camera.scale;
  const Real far = 1e30f, none = 0.0f;
  PlacedLanes placed{far, -far, far, -far, none, none, none, none, none, none, Vec3(none), Vec3(none)};
  Real before_x = 0.0f, before_y = 0.0f, root_x = 0.0f, root_y = 0.0f;
  for (int k = 0; k <= set.segments; ++k) {
    const Quad point = gather_quad(&set.points[0].position.x + 4 * k, rows);
    const Vec3 position{point.real(0), point.real(1), point.real(2)}, apart = position - Vec3(camera.position);
    const Real distance = dot(apart, Vec3(camera.forward));
    const Mask seen = distance > near_distance;
    const Real inverse = 1.0f / max(distance, near_distance), scale = inverse * camera.scale;
    const Real x = mul_add(dot(apart, Vec3(camera.right)), scale, camera.middle.x);
    const Real y = Real(camera.middle.y) - dot(apart, Vec3(camera.up)) * scale;
    const Real half = point.real(3) * inverse * wider;
    store(x, knots.x[k]), store(y, knots.y[k]), store(half, knots.half_width[k]);
    store(select(seen, inverse, 0.0f), knots.inverse[k]);
    if (k == 0) placed.root = position, root_x = x, root_y = y;
    if (k > 0) {
      const Real segment = length(Vec2{x - before_x, y - before_y});
      placed.arc_length += segment, placed.longest = max(placed.longest, segment);
      placed.length += length(position - placed.tip);
    }
    placed.widest = max(placed.widest, half);
    before_x = x, before_y = y, placed.tip = position;
    placed.left = select(seen, min(placed.left, x - half), placed.left);
    placed.right = select(seen, max(placed.right, x + half), placed.right);
    placed.top = select(seen, min(placed.top, y - half), placed.top);
    placed.bottom = select(seen, max(placed.bottom, y + half), placed.bottom);
    placed.nearest = select(seen, max(placed.nearest, inverse), placed.nearest);
  }
  placed.reach = length(Vec2{before_x - root_x, before_y - root_y});
  return placed;
}

/// What determines how deep in the fur a strand is visible.
struct DepthLanes {
  Vec3 root, tip, normal;
  Real reach, length;  // StrandRoot::reach; length of the fur around the strand over nominal_length
};

/// Returns for each lane the last knot that is hidden because at least seen_depth strands lie in front of it; 0 for
/// none.
HWY_INLINE Real hidden_knot(const RasterScene& scene, const DepthLanes& strand, float crowding, int segments) {
  const FrameBlock& frame = scene.optics.frame;
  const Vec3 to_camera = unit(Vec3(scene.camera.position) - strand.root), along = unit(strand.tip - strand.root);
  const Real facing = dot(strand.normal, to_camera);
  Real hidden = 0.0f;
  Mask deep = facing < 2.0f;  // lanes whose knots so far are all hidden: at first all lanes
  for (int k = 1; k < segments; ++k) {
    const Real height = strand.reach * (static_cast<float>(k) / static_cast<float>(segments));
    const Int slice = to_int(clamp(height * static_cast<float>(slice_count), 0.0f, slice_count - 1.0f));
    const Real above = gather(&frame.depth_above[0].x, slice) * strand.length * crowding;
    const Real crossed = strands_crossed(above, exit_path_length(height, facing), along, to_camera);
    deep = deep & (crossed >= seen_depth);
    if (!any(deep)) break;
    hidden = select(deep, static_cast<float>(k), hidden);
  }
  return hidden;
}

/// Returns which lanes touch the box and may be visible in it. A strand is hidden if all of its knots lie in the box
/// and behind all skin around them (`hidden`). Strands too long or too wide for hiding_radius are always kept; this
/// allows for two segments drawn as one and for deep parts drawn `wider`. So a strand that is left out is visible
/// nowhere, whatever the box.
HWY_INLINE Mask seen_lanes(const PlacedLanes& placed, const KnotLanes& knots, int segments, Real wider,
                           const PixelBox& box, std::span<const float> hidden) {
  const auto left = static_cast<float>(box.left), top = static_cast<float>(box.top);
  const auto right = static_cast<float>(box.right), bottom = static_cast<float>(box.bottom);
  const Real beside = drawn_margin + (wider - 1.0f) * placed.widest;
  const Mask inside = (placed.right > left - beside) & (placed.left < right + beside) & (placed.bottom > top - beside) &
                      (placed.top < bottom + beside);
  if (!any(inside)) return inside;
  Mask seen = 2.0f * placed.longest + wider * placed.widest > hiding_radius - drawn_margin;
  const int across = tiles_of(box).across * (tile_side / hiding_side);
  for (int k = segments; k >= 0 && !all(seen); --k) {
    const Real x = load(knots.x[k]), y = load(knots.y[k]);
    seen = seen | (x < left) | (x >= right) | (y < top) | (y >= bottom);
    const Real bx = floor((clamp(x, left, right - 1.0f) - left) * (1.0f / hiding_side));
    const Real by = floor((clamp(y, top, bottom - 1.0f) - top) * (1.0f / hiding_side));
    const Real hidden_inverse = gather(hidden.data(), to_int(mul_add(by, static_cast<float>(across), bx)));
    seen = seen | (load(knots.inverse[k]) > hidden_inverse);
  }
  return inside & seen;
}

/// Returns those of `lanes` that touch a tile that is to be drawn.
HWY_INLINE std::uint32_t drawn_lanes(const TileMask& drawn, const PlacedLanes& placed, Real wider,
                                     std::uint32_t lanes) {
  const Real beside = drawn_margin + (wider - 1.0f) * placed.widest;
  HWY_ALIGN float left[lane_count], top[lane_count], right[lane_count], bottom[lane_count];
  store(placed.left - beside, left), store(placed.top - beside, top);
  store(placed.right + beside, right), store(placed.bottom + beside, bottom);
  std::uint32_t kept = 0;
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    if (drawn.touches(left[lane], top[lane], right[lane], bottom[lane])) kept |= 1u << lane;
  }
  return kept;
}

/// Returns the distance between two knots, pixels.
HWY_INLINE float apart(const PlacedKnot& a, const PlacedKnot& b) {
  const float x = a.x - b.x, y = a.y - b.y;
  return std::sqrt(x * x + y * y);
}

/// Widens the knots of a curl whose turns are too small to be drawn, so that its coverage stays the same: `arc_length`
/// is its length along the turns, pixels. The increase is at most the curl's own width, about one `step` between its
/// knots, and at most a pixel to each side.
HWY_INLINE void widen_for_curls(std::span<PlacedKnot> knots, float arc_length, float step) {
  float drawn = 0;
  for (std::size_t k = 1; k < knots.size(); ++k) drawn += apart(knots[k], knots[k - 1]);
  const float more = arc_length / std::max(drawn, 1e-3f);
  if (more < 1.1f) return;
  for (PlacedKnot& knot : knots)
    knot.half_width = std::min(knot.half_width * more, knot.half_width + std::min(step, 1.0f));
}

/// Extends the tip: a strand ends in a half ball, which covers as much as a longer strand with a flat end would.
HWY_INLINE void round_tip(PlacedKnot& tip, const PlacedKnot& before, float wider) {
  constexpr float half_disc = 0.785f;  // area of a half disc over that of the rectangle around it
  const float more = half_disc * tip.half_width / (wider * std::max(apart(tip, before), 1e-3f));
  tip.x += more * (tip.x - before.x), tip.y += more * (tip.y - before.y);
}

/// How a strand that is kept is drawn.
struct KeptLane {
  int lane, first, deep;    // lane; first knot drawn; knots before `deep` are visible only through gaps between strands
  float arc_length, reach;  // as in PlacedLanes
  float wider;              // its width over that in the whole coat
  float packing;            // share of the skin that the coat's strands fill, over (half_width / inverse)^2
};

/// Returns the half width of a knot, widened for packing. Strands do not intersect each other, so the thicker they are
/// for their distance, the less is visible between them: strands too thin to be resolved cover more than randomly
/// placed ones would.
HWY_INLINE float packed_half(const KeptLane& kept, const PlacedKnot& knot) {
  const float over = knot.half_width / std::max(knot.inverse, 1e-9f);
  const float unresolved = std::clamp(1.5f - knot.half_width, 0.0f, 1.0f);
  return knot.half_width / (1 - unresolved * std::min(max_packed, kept.packing * over * over));
}

/// Appends the knots of a lane, thinned so that they are at least about min_segment pixels apart. Deep knots are wider,
/// but not so wide that they would be visible beside the fur above them.
HWY_INLINE void append_lane(const KnotLanes& knots, const KeptLane& kept, int segments, PlacedStrands& placed) {
  const int remaining = segments - kept.first;
  const float over = 1 / static_cast<float>(segments);
  const float wanted = kept.arc_length / min_segment * static_cast<float>(remaining) * over;
  const int count = std::min(remaining, std::max(2, static_cast<int>(std::min(wanted, 64.0f))));
  const float step = static_cast<float>(remaining) / static_cast<float>(count);
  const std::size_t at = placed.knots.size();
  placed.knots.resize(at + static_cast<std::size_t>(count) + 1), placed.along.resize(placed.knots.size());
  PlacedKnot* knot = &placed.knots[at];
  float* along = &placed.along[at];
  for (int i = 0; i <= count; ++i, ++knot, ++along) {
    const int k = kept.first + static_cast<int>(static_cast<float>(i) * step + 0.01f);
    knot->x = knots.x[k][kept.lane], knot->y = knots.y[k][kept.lane], knot->inverse = knots.inverse[k][kept.lane];
    const float thin = knot->half_width = knots.half_width[k][kept.lane];
    const float packed = knot->half_width = packed_half(kept, *knot);
    *along = static_cast<float>(k) * over;
    const float above = kept.reach * (1 - *along);  // pixels
    if (k < kept.deep) knot->half_width = std::clamp(0.5f * above, packed, std::max(packed, deep_strand_factor * thin));
  }
  round_tip(placed.knots.back(), placed.knots[placed.knots.size() - 2], kept.wider);
  if (count < remaining)
    widen_for_curls(std::span(placed.knots).subspan(at), kept.arc_length * static_cast<float>(remaining) * over,
                    kept.arc_length * over);
  placed.first.push_back(static_cast<std::uint32_t>(placed.knots.size()));
}

HWY_INLINE DepthLanes depth_lanes(const StrandSet& set, const std::uint32_t* ids, Vec3 root, Vec3 tip,
                                  Real arc_length) {
  const Int roots = strand_rows(ids, root_stride);
  const Quad normal = gather_quad(&set.roots[0].normal.x, roots);
  const Real reach = gather(&set.roots[0].reach, roots);
  const Real straight = max(length(tip - root), 0.02f * arc_length + 1e-9f);
  const Real exposed_length = arc_length / (1.0f + curl_in_shadow * max(arc_length / straight - 1.0f, 0.0f));
  return {root,
          tip,
          {normal.real(0), normal.real(1), normal.real(2)},
          reach,
          exposed_length / max(reach, 0.01f) * static_cast<float>(1 / nominal_length)};
}

/// Returns the share of the skin that strands of radius 1 would fill: the flatter they lie, the more.
HWY_INLINE Real packing_of(const GrownPart& part, const DepthLanes& depth) {
  const Real upright = max(dot(unit(depth.tip - depth.root), depth.normal), 0.2f);
  constexpr float there = 0.7f;  // share of the strands that reach the visible height
  return there * part.packing / (part.wider * part.wider) / upright;
}

HWY_INLINE void place_all(const RasterScene& scene, const GrownPart& part, const PixelBox& box,
                          std::span<const float> hidden_by_skin, KeptStrands& kept, PlacedStrands& placed) {
  const StrandSet& set = *part.strands;
  KnotLanes knots;
  const std::size_t count = kept.ids.size();
  const std::uint32_t from_root_end = count > 0 ? strands_from_root(kept.ids.back()) : 0;
  std::size_t stay = 0;
  if (placed.first.empty()) placed.first.push_back(0);
  for (std::size_t i = 0; i < count; i += lane_count) {
    std::uint32_t ids[lane_count];
    float widened[lane_count], wider[lane_count], arc_length[lane_count], reach[lane_count], hidden[lane_count],
        packing[lane_count];
    for (std::size_t l = 0; l < lane_count; ++l) {
      const std::size_t at = std::min(i + l, count - 1);
      ids[l] = kept.ids[at], widened[l] = kept.widened[at];
      wider[l] = ids[l] < from_root_end ? static_cast<float>(deep_strand_factor) : 1.0f;
    }
    const PlacedLanes lanes = place_lanes(scene.camera, set, ids, widened, knots);
    std::uint32_t seen = bits_of(seen_lanes(lanes, knots, set.segments, load(wider), box, hidden_by_skin));
    if (count - i < lane_count) seen &= (1u << (count - i)) - 1;
    if (scene.drawn) seen = drawn_lanes(*scene.drawn, lanes, load(wider), seen);
    if (seen == 0) continue;
    const DepthLanes depth = depth_lanes(set, ids, lanes.root, lanes.tip, lanes.length);
    store(lanes.arc_length, arc_length), store(lanes.reach, reach), store(packing_of(part, depth), packing);
    store(hidden_knot(scene, depth, part.crowding, set.segments), hidden);
    for (; seen != 0; seen &= seen - 1) {
      const int lane = std::countr_zero(seen);
      kept.ids[stay] = ids[lane], kept.widened[stay] = widened[lane], ++stay;
      const int deep = static_cast<int>(hidden[lane]);
      const float more = widened[lane] * scene.camera.scale;
      append_lane(knots,
                  {lane, ids[lane] < from_root_end ? 0 : deep, deep, arc_length[lane], reach[lane],
                   part.wider * widened[lane], packing[lane] / (more * more)},
                  set.segments, placed);
    }
  }
  kept.ids.resize(stay), kept.widened.resize(stay);
}

// Which strands may look different, and where they lie on the picture; a strand a lane.

/// Returns the BlockChange bits of all blocks that contain a knot of each lane's strand.
HWY_INLINE Int changed_lanes(const BlockLayout& layout, std::span<const std::int32_t> blocks, const StrandSet& set,
                             const std::uint32_t* ids) {
  const Int rows = strand_rows(ids, (set.segments + 1) * 4);
  Int changed = splat(0);
  for (int k = 0; k <= set.segments; ++k) {
    const Quad point = gather_quad(&set.points[0].position.x + 4 * k, rows);
    const Vec3 at = (Vec3{point.real(0), point.real(1), point.real(2)} - Vec3(layout.low)) * (1 / layout.side);
    const auto block = [](Real along, int count)
                           HWY_ATTR { return to_int(clamp(along, 0.0f, static_cast<float>(count) - 0.5f)); };
    const Int row = hn::Add(hn::Mul(block(at.z, layout.count.z), splat(layout.count.y)), block(at.y, layout.count.y));
    const Int index = hn::Add(hn::Mul(row, splat(layout.count.x)), block(at.x, layout.count.x));
    changed = hn::Or(changed, gather(blocks.data(), index));
  }
  return changed;
}

HWY_INLINE void find_all_changed(const RasterScene& scene, const GrownPart& part, const KeptStrands& kept,
                                 std::span<const std::int32_t> blocks, std::vector<StrandBox>& boxes) {
  const StrandSet& set = *part.strands;
  KnotLanes knots;
  const std::size_t count = kept.ids.size();
  const std::uint32_t from_root_end = count > 0 ? strands_from_root(kept.ids.back()) : 0;
  boxes.resize(count);
  for (std::size_t i = 0; i < count; i += lane_count) {
    std::uint32_t ids[lane_count];
    float widened[lane_count], wider[lane_count];
    for (std::size_t l = 0; l < lane_count; ++l) {
      const std::size_t at = std::min(i + l, count - 1);
      ids[l] = kept.ids[at], widened[l] = kept.widened[at];
      wider[l] = ids[l] < from_root_end ? static_cast<float>(deep_strand_factor) : 1.0f;
    }
    const PlacedLanes lanes = place_lanes(scene.camera, set, ids, widened, knots);
    const Real beside = drawn_margin + load(wider) * lanes.widest;
    HWY_ALIGN float left[lane_count], top[lane_count], right[lane_count], bottom[lane_count];
    store(lanes.left - beside, left), store(lanes.top - beside, top);
    store(lanes.right + beside, right), store(lanes.bottom + beside, bottom);
    HWY_ALIGN std::int32_t changed[lane_count];
    hn::Store(changed_lanes(scene.grid->blocks(), blocks, set, ids), int_tag, changed);
    for (std::size_t l = 0; l < lane_count && i + l < count; ++l)
      boxes[i + l] = {
          left[l], top[l], right[l], bottom[l], (changed[l] & fur_changed) != 0, (changed[l] & light_changed) != 0};
  }
}

}  // namespace pelage::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
