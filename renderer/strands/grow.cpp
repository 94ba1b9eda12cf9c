#include "renderer/strands/grow.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "renderer/pattern/pattern.h"
#include "renderer/strands/even_order.h"
#include "renderer/strands/root_fields.h"
#include "renderer/strands/sampling.h"
#include "renderer/strands/strand_look.h"
#include "renderer/strands/tile_strands.h"

namespace pelage {

namespace {

constexpr double looked_through = 16;  // maximum number of copies examined for each strand that grows
constexpr double min_of_tile = 256;    // minimum number of strands of the tile that are examined

bool any_above_default(std::span<const float> field) {
  return std::any_of(field.begin(), field.end(), [](float value) { return value > 0; });
}

/// Returns the share of the tile's strands whose copies are examined, so that a small share does not examine every
/// copy. It is a power of 1/2.
double tile_share_of(double share, int count) {
  double of_tile = 1;
  while (of_tile > looked_through * share && of_tile * count > 2 * min_of_tile) of_tile /= 2;
  return of_tile;
}

/// Returns a random number in [0, 1) for a strand in a copy of the tile.
float number_of(const TileCopy& copy, std::uint64_t stream) {
  const std::uint64_t tile =
      std::uint64_t{static_cast<std::uint32_t>(copy.tiles.x)} << 32 | static_cast<std::uint32_t>(copy.tiles.y);
  return static_cast<float>(mix_bits(mix_bits(copy.strand | stream << 32) ^ tile) >> 40) * 0x1p-24f;
}

std::uint64_t recipe_hash(const GrowRecipe& recipe, const FurModel& model, std::uint64_t tile_hash) {
  const Coat& coat = recipe.coat;
  Hash hash;
  hash.add(tile_hash);
  for (const double value :
       {coat.tile, coat.curl, coat.curl_turns, coat.clump_size, coat.wetness, coat.root_share, coat.tufts.gather,
        coat.tufts.size, recipe.share, recipe.widening, recipe.guard_share, recipe.extra_wetness, coat.bend, coat.mess})
    hash.add(value);
  for (const std::uint64_t value :
       {std::uint64_t{coat.seed}, std::uint64_t{coat.tufts.seed}, model.id,
        static_cast<std::uint64_t>(coat.tufts.scales), static_cast<std::uint64_t>(coat.lean_curve == LeanCurve::root),
        static_cast<std::uint64_t>(recipe.model_colours)})
    hash.add(value);
  hash.add_value(make_pattern_block(coat));
  for (const RampStop& stop : coat.ramp) hash.add_value(stop.colour);  // lightness is relative to the largest of them
  return hash.value();
}

/// Returns the fields before anything moves the fur.
FurFields without_motion(FurFields fields) {
  if (!fields.still.empty()) fields.direction = fields.still;
  return fields;
}

std::vector<std::uint64_t> vertex_hashes(const FurModel& model, std::span<const FurVertex> vertices,
                                         std::span<const FurVertex> closing) {
  std::vector<std::uint64_t> hashes;
  hashes.reserve(vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    Hash hash;
    hash.add_value(std::array{model.positions[v], model.normals[v], model.tangents[v]});
    hash.add_value(vertices[v]);
    if (!closing.empty()) hash.add_value(closing[v].direction);
    hashes.push_back(hash.value());
  }
  return hashes;
}

/// Returns the vertices with the moved directions; empty if nothing moves.
std::vector<FurVertex> moved_vertices(const std::vector<FurVertex>& vertices, std::span<const glm::vec2> directions) {
  if (directions.empty()) return {};
  std::vector<FurVertex> moved(vertices);
  for (std::size_t v = 0; v < moved.size(); ++v) moved[v].direction = directions[v];
  return moved;
}

}  // namespace

struct CoatTables {
  CoatTables(const GrowRecipe& recipe, int segments)
      : coat(recipe.coat),
        share(recipe.share),
        leans(coat.lean_curve, coat.root_share),
        tile(coat, segments),
        tile_share(tile_share_of(share, coat.count)),
        cells(tile.strands(), coat.tile, tile_share),
        tile_hash(tile.hash()) {}

  Coat coat;
  double share;  // GrowRecipe::share
  LeanTable leans;
  TileStrands tile;
  double tile_share;  // share of the tile's strands in `cells`; share / tile_share of their copies grow
  TileCells cells;
  std::uint64_t tile_hash;
};

const LeanTable& leans_of(const CoatTables& tables) { return tables.leans; }

namespace {

std::shared_ptr<const CoatTables> tables_for(const GrowRecipe& recipe, int segments,
                                             std::shared_ptr<const CoatTables> before) {
  const bool same =
      before && before->coat == recipe.coat && before->share == recipe.share && before->tile.segments() == segments;
  return same ? std::move(before) : std::make_shared<const CoatTables>(recipe, segments);
}

/// The form of a strand on its root, without the lean of the fur.
struct StandingForm {
  float reach = 1, stretch = 1;  // as in StrandRoot
  std::array<glm::vec3, 64> sideways;
};

StrandRoot root_of(const Strand& strand, const TileCopy& copy, std::uint32_t triangle, const RootFields& root,
                   const StandingForm& standing, double extra_wetness) {
  const auto to_uint16 = [](double share) {
    return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(share, 0.0, 1.0)));
  };
  return {root.normal,
          static_cast<float>(strand.number),
          standing.reach,
          standing.stretch,
          std::min(root.wetness + static_cast<float>(extra_wetness), 1.0f),
          triangle,
          {to_uint16(copy.share.y), to_uint16(copy.share.z)}};
}

}  // namespace

struct Grower::Impl {
  /// A triangle when the shutter opens and, if anything moves, when it closes.
  struct MovingTriangle {
    std::uint32_t index;  // index of the model's triangle
    FurTriangle opening;
    std::optional<FurTriangle> closing;
  };
  /// The strands of a chunk. Roots are in the rest pose, so that the order of strands stays when the model moves.
  struct Found {
    std::vector<MovingTriangle> triangles;
    std::vector<std::pair<std::uint32_t, TileCopy>> strands;  // index in `triangles`, copy
    std::vector<glm::vec3> roots;
  };

  Impl(const FurModel& surface, const FurFields& fields, const GrowRecipe& how,
       std::shared_ptr<const CoatTables> before)
      : model(surface),
        recipe(how),
        vertices(fur_vertices(surface, without_motion(fields))),
        closing(moved_vertices(vertices, fields.closing)),
        bent(moved_vertices(vertices, fields.still.empty() ? fields.still : fields.direction)),
        tables(tables_for(how, strand_segments(how.coat, any_above_default(fields.paint.curl)), std::move(before))),
        tile(tables->tile),
        form(recipe.coat, tile),
        colours(model, recipe, tile),
        shared_hash(recipe_hash(how, surface, tables->tile_hash)),
        hashes(vertex_hashes(surface, vertices, closing)) {
    if (has_pattern(recipe.coat)) pattern = make_pattern_block(recipe.coat);
  }

  bool bald(std::uint32_t triangle) const;
  bool keeps(const FurTriangle& triangle, const TileCopy& copy) const;
  /// Adds the strands that grow on a triangle.
  void find_strands(std::uint32_t index, std::vector<TileCopy>& copies, Found& found) const;
  void append(const MovingTriangle& triangle, const TileCopy& copy, StrandSet& set) const;
  StandingForm form_of(const TileCopy& copy, const RootFields& root) const;
  StandingForm guard_hair(const TileCopy& copy, const RootFields& root) const;
  TriangleBend bend_of(std::uint32_t triangle) const;

  FurModel model;
  GrowRecipe recipe;
  std::vector<FurVertex> vertices;
  std::vector<FurVertex> closing;  // vertices when the shutter closes; empty if nothing moves
  std::vector<FurVertex> bent;     // vertices moved by wind or body; empty if nothing moves
  std::shared_ptr<const CoatTables> tables;
  const TileStrands& tile;
  StrandForm form;
  StrandColours colours;
  std::optional<PatternBlock> pattern;
  std::uint64_t shared_hash;          // hash of all inputs that chunks share
  std::vector<std::uint64_t> hashes;  // hash of each vertex
};

bool Grower::Impl::bald(std::uint32_t triangle) const {
  const glm::uvec3 t = model.triangles[triangle];
  return vertices[t.x].length <= 0 && vertices[t.y].length <= 0 && vertices[t.z].length <= 0;
}

bool Grower::Impl::keeps(const FurTriangle& triangle, const TileCopy& copy) const {
  const glm::vec3 share(copy.share);
  const float density = triangle.density(share);
  return number_of(copy, 1) < triangle.grown(share) &&
         number_of(copy, 2) < static_cast<float>(recipe.share / tables->tile_share) &&
         (density >= 1 || static_cast<float>(tile[copy.strand].number) < density);
}

StandingForm Grower::Impl::form_of(const TileCopy& copy, const RootFields& root) const {
  StandingForm standing;
  standing.reach = static_cast<float>(tile[copy.strand].length_share);
  form.sideways(copy.strand, root, std::span(standing.sideways).first(static_cast<std::size_t>(tile.segments()) + 1));
  return standing;
}

/// Returns the form of a guard hair: it joins no clumps or locks, has a bow of its own, and may be longer than the fur.
StandingForm Grower::Impl::guard_hair(const TileCopy& copy, const RootFields& root) const {
  StandingForm standing;
  const float longer = number_of(copy, 4);
  standing.stretch = glm::mix(0.8f, 1.25f, longer * longer);
  const float angle = 2 * std::numbers::pi_v<float> * number_of(copy, 5);
  const glm::vec3 aside = std::cos(angle) * root.tile_u + std::sin(angle) * root.tile_v;
  const auto longest = static_cast<float>((recipe.coat.bend + recipe.coat.mess) * nominal_length);
  const float bow = longest * std::min(root.length / static_cast<float>(nominal_length), 1.0f);
  for (int k = 0; k <= tile.segments(); ++k)
    standing.sideways[static_cast<std::size_t>(k)] = aside * (bow * tile.along(k) * tile.along(k));
  return standing;
}

void Grower::Impl::append(const MovingTriangle& triangle, const TileCopy& copy, StrandSet& set) const {
  const glm::vec3 share(copy.share);
  const RootFields root = triangle.opening.fields(share);
  const bool guards = number_of(copy, 3) < static_cast<float>(recipe.guard_share);
  const StandingForm standing = guards ? guard_hair(copy, root) : form_of(copy, root);
  const auto knots = static_cast<std::size_t>(tile.segments()) + 1, first = set.points.size();
  set.points.resize(first + knots), set.colours.resize(first + knots);
  const float wider = std::max(root.width, 0.0f) * static_cast<float>(recipe.widening);
  for (std::size_t i = 0; i < knots; ++i) {
    const int k = static_cast<int>(i);
    const float s = tile.along(k) * standing.reach;
    const float radius = std::max(wider * tile.radius(copy.strand, k), min_strand_radius);
    const auto point = [&](const FurTriangle& of) {
      return StrandPoint{root.position + standing.stretch * of.curves().at(share, s) + standing.sideways[i], radius};
    };
    set.points[first + i] = point(triangle.opening);
    if (triangle.closing) set.closing.push_back(point(*triangle.closing));
  }
  set.to_mean.push_back(colours.write(copy.strand, root, std::span(set.colours).subspan(first, knots)));
  set.roots.push_back(root_of(tile[copy.strand], copy, triangle.index, root, standing, recipe.extra_wetness));
}

TriangleBend Grower::Impl::bend_of(std::uint32_t triangle) const {
  const PatternBlock* block = pattern ? &*pattern : nullptr;
  const std::span<const glm::vec3> rest = model.rest_positions.empty() ? model.positions : model.rest_positions;
  TriangleBend bend;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t v = model.triangles[triangle][k];
    const auto lean = [&](const FurVertex& vertex) {
      return corner_lean(vertex, rest[v], model.normals[v], model.tangents[v], block);
    };
    bend[static_cast<std::size_t>(k)] = {lean(vertices[v]), lean(bent[v])};
  }
  return bend;
}

void Grower::Impl::find_strands(std::uint32_t index, std::vector<TileCopy>& copies, Found& found) const {
  if (bald(index)) return;
  tables->cells.find(tile_triangle(model.corners[index]), copies);
  if (copies.empty()) return;
  const PatternBlock* block = pattern ? &*pattern : nullptr;
  const auto number = static_cast<std::uint32_t>(found.triangles.size());
  found.triangles.push_back({index, FurTriangle(model, vertices, index, tables->leans, block), {}});
  MovingTriangle& triangle = found.triangles.back();
  if (!closing.empty()) triangle.closing.emplace(model, closing, index, tables->leans, block);
  for (const TileCopy& copy : copies) {
    if (!keeps(triangle.opening, copy)) continue;
    found.strands.emplace_back(number, copy);
    found.roots.push_back(triangle.opening.rest_position(glm::vec3(copy.share)));
  }
}

Grower::Grower(const FurModel& model, const FurFields& fields, const GrowRecipe& recipe,
               std::shared_ptr<const CoatTables> before)
    : impl_(std::make_unique<const Impl>(model, fields, recipe, std::move(before))) {}

Grower::~Grower() = default;

StrandSet Grower::grow(const StrandChunk& chunk, std::size_t max) const {
  const Impl& grower = *impl_;
  Impl::Found found;
  std::vector<TileCopy> copies;
  for (const std::uint32_t triangle : chunk) grower.find_strands(triangle, copies, found);
  EvenOrder even = even_order(found.roots);
  StrandSet set;
  set.segments = grower.tile.segments();
  for (const std::uint32_t strand : even.order) {
    const auto& [number, copy] = found.strands[strand];
    const Impl::MovingTriangle& triangle = found.triangles[number];
    grower.append(triangle, copy, set);
    if (set.bytes() > max) break;
  }
  even.neighbour.resize(set.count());
  set.neighbour = std::move(even.neighbour);
  set.points.shrink_to_fit(), set.closing.shrink_to_fit();
  set.colours.shrink_to_fit(), set.to_mean.shrink_to_fit(), set.roots.shrink_to_fit();  // hundreds of sets are held
  return set;
}

void Grower::bend(const StrandChunk& chunk, StrandSet& set) const {
  const Impl& grower = *impl_;
  assert(grower.bent.size() == grower.vertices.size());
  std::vector<std::uint32_t> triangles(chunk);
  std::sort(triangles.begin(), triangles.end());
  std::vector<LeanCurves> bends(triangles.size());
  std::transform(triangles.begin(), triangles.end(), bends.begin(), [&](std::uint32_t triangle) {
    const TriangleBend bend = grower.bend_of(triangle);
    LeanCurves still, moved;
    for (int k = 0; k < 3; ++k) {
      still.set(k, grower.tables->leans, bend[static_cast<std::size_t>(k)].still);
      moved.set(k, grower.tables->leans, bend[static_cast<std::size_t>(k)].moved);
    }
    return moved.less(still);
  });
  StrandPoint* point = set.points.data();
  for (const StrandRoot& root : set.roots) {
    const auto triangle = std::lower_bound(triangles.begin(), triangles.end(), root.triangle);
    const LeanCurves& curves = bends[static_cast<std::size_t>(triangle - triangles.begin())];
    const glm::vec2 share = glm::vec2(root.share[0], root.share[1]) / 65535.0f;
    const glm::vec3 shares(1 - share.x - share.y, share);
    for (int k = 0; k <= set.segments; ++k, ++point)
      point->position += root.stretch * curves.at(shares, grower.tile.along(k) * root.reach);
  }
}

TriangleBend Grower::bend_of(std::uint32_t triangle) const { return impl_->bend_of(triangle); }

const LeanTable& Grower::leans() const { return impl_->tables->leans; }

const std::shared_ptr<const CoatTables>& Grower::tables() const { return impl_->tables; }

std::array<SkinLook, 3> Grower::skin(std::uint32_t triangle) const {
  constexpr float covering = 0.008f;  // length of fur that hides the skin, sizes
  std::array<SkinLook, 3> corners;
  for (int k = 0; k < 3; ++k) {
    const FurVertex& vertex = impl_->vertices[impl_->model.triangles[triangle][k]];
    const RootFields root = corner_fields(impl_->model, impl_->vertices, triangle, k);
    const float thin = 1 - std::clamp(vertex.density, 0.0f, 1.0f);
    const float grown = glm::smoothstep(0.0f, covering, vertex.length) * (1 - thin * thin * thin);
    corners[static_cast<std::size_t>(k)] = {impl_->colours.under(root), grown, vertex.bare, vertex.wetness};
  }
  return corners;
}

std::array<SkinLook, 3> skin_under(std::span<const std::array<SkinLook, 3>> of_each) {
  if (of_each.size() == 1) return of_each.front();
  std::array<SkinLook, 3> corners = of_each.front();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    SkinLook& corner = corners[k];
    glm::vec3 under(0);
    float sum = 0, uncovered = 1;
    for (const auto& one : of_each) {
      under += one[k].grown * one[k].under, sum += one[k].grown, uncovered *= 1 - one[k].grown;
      corner.wetness = std::max(corner.wetness, one[k].wetness);
    }
    if (sum > 0) corner.under = under / sum, corner.grown = 1 - uncovered;
  }
  return corners;
}

std::uint64_t Grower::bend_fingerprint(const StrandChunk& chunk) const {
  if (impl_->bent.empty()) return 0;
  Hash hash;
  for (const std::uint32_t triangle : chunk) {
    const glm::uvec3 t = impl_->model.triangles[triangle];
    for (const std::uint32_t v : {t.x, t.y, t.z}) hash.add_value(impl_->bent[v].direction);
  }
  return hash.value();
}

std::uint64_t Grower::fingerprint(const StrandChunk& chunk) const {
  Hash hash;
  hash.add(impl_->shared_hash);
  for (const std::uint32_t triangle : chunk) {
    const glm::uvec3 t = impl_->model.triangles[triangle];
    for (const std::uint32_t v : {t.x, t.y, t.z}) hash.add(impl_->hashes[v]);
    hash.add_value(impl_->model.corners[triangle]);
  }
  return hash.value();
}

}  // namespace pelage
