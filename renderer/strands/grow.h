// Grows strands from the groom: every strand of the sample tile, wherever the tile lies on the surface. Slices, fields,
// tufts, patterns and paint, which shells sample in shaders (renderer/shaders), become geometry here.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/strands/grow_recipe.h"
#include "renderer/strands/root_fields.h"
#include "renderer/strands/strand_set.h"

namespace pelage {

inline constexpr float min_strand_radius = 1e-7f;  // sizes

/// A region of the surface that is grown at a time: indices of triangles of the model that lie together.
using StrandChunk = std::vector<std::uint32_t>;

/// Divides the surface into compact chunks with at most `strands_each` strands of all coats together each, or of one
/// triangle.
std::vector<StrandChunk> make_chunks(const FurModel& model, EachCoat<Coat> coats, double strands_each);

/// The look of the skin between strands, at a corner of a triangle.
struct SkinLook {
  glm::vec3 under{0};           // colour of skin under fur, linear
  float grown = 0;              // share of the skin that has that colour, [0, 1]; the rest has the model's own
  float bare = 0, wetness = 0;  // painted, [0, 1]
};

/// Returns the look of the skin between the strands of several coats, from the look under each of them.
std::array<SkinLook, 3> skin_under(std::span<const std::array<SkinLook, 3>> of_each);

/// Tables that all strands of a coat share.
struct CoatTables;
/// Returns the table of the coat's lean curves.
const LeanTable& leans_of(const CoatTables& tables);

/// Grows strands. It is prepared once for a state of the fields and then grows chunks on any thread. The model's views
/// must outlive it. Deterministic: strands depend neither on the division into chunks nor on threads. A strand of n
/// segments takes 20 (n + 1) + 44 bytes; n is 6 for straight strands and up to 48 for curls and waves (strand_segments
/// in tile_strands.h).
///
/// Where shells repeat a tile made for fur of one length, strands of shorter fur move sideways by at most their length.
/// A share below 1/16 also leaves out whole strands of the tile, down to 256 of them, so that at most about 16 copies
/// are examined for each strand that grows. Limits: a triangle grows at most 4,194,304 strands, and none if its
/// position on the tile is more than 100 sizes from the origin or if it has no area on the tile (TileCells). Callers
/// that have to bound memory check expected_strands first.
class Grower {
 public:
  /// `before`: tables of an earlier grower; they are reused if they are the same, null for none.
  Grower(const FurModel& model, const FurFields& fields, const GrowRecipe& recipe,
         std::shared_ptr<const CoatTables> before = nullptr);
  ~Grower();

  /// Returns the strands of a chunk. If they would take more than `max` bytes, it returns only some of them, whose size
  /// also exceeds `max`. Fur of length 0 has no strands; density keeps the strands whose number is below it. A radius
  /// is at least 1e-7, so that strands without width do not cause a division by 0.
  StrandSet grow(const StrandChunk& chunk, std::size_t max = std::numeric_limits<std::size_t>::max()) const;
  /// Moves the strands of a chunk from their lean by FurFields::still, which must not be empty, to their lean by
  /// FurFields::direction.
  void bend(const StrandChunk& chunk, StrandSet& set) const;
  /// Returns the lean at the corners of a triangle before and after `bend`.
  TriangleBend bend_of(std::uint32_t triangle) const;
  /// Returns the table of lean curves.
  const LeanTable& leans() const;
  /// Returns the look of the skin at the corners of a triangle.
  std::array<SkinLook, 3> skin(std::uint32_t triangle) const;
  /// Returns a 64-bit fingerprint of everything that `grow(chunk)` and `skin` of its triangles depend on: it stays the
  /// same as long as their results do.
  std::uint64_t fingerprint(const StrandChunk& chunk) const;
  /// Returns a fingerprint of what `bend(chunk)` depends on besides that; 0 if nothing is bent.
  std::uint64_t bend_fingerprint(const StrandChunk& chunk) const;
  const std::shared_ptr<const CoatTables>& tables() const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

/// Returns whiskers, lashes and brows (renderer/curves) as strands. They are independent of the fur's ramp and fields.
StrandSet grow_curves(std::span<const FurCurves> curves);

}  // namespace pelage
