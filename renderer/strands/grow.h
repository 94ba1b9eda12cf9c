// Strands from the groom: every strand of the sample tile wherever the tile lies on the surface. What shells read from
// slices, fields, tufts, patterns and paint (renderer/shaders), strands have as geometry.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/strands/root_fields.h"
#include "renderer/strands/strand_set.h"

namespace pelage {

inline constexpr float min_strand_radius = 1e-7f;  // sizes

/// What says how strands grow beside the model and its fields.
struct GrowRecipe {
  Coat coat;
  bool model_colours = false;  // hue from the model, lightness from the ramp (base_colour.glsl)
  double share = 1;            // of the strands that grow, by a number of their own, (0, 1]
  double guard_share = 0;      // of the strands that stand as guard hairs, [0, 1]
  double widening = 1;         // factor on their width, >= 1: 1 / share keeps what they cover
  double wetter = 0;           // than FurFrame::wetness, [0, 1]

  bool operator==(const GrowRecipe&) const = default;
};

/// A part of the surface that is grown at a time: indices of the model's pieces that lie together.
using StrandChunk = std::vector<std::uint32_t>;

/// Returns the strands of whole fur with one on a square of a size, before density, bare skin and `share` reduce them.
double fur_area(const FurModel& model);

/// How the coats of a frame grow whole, each of as wide strands as it has. `area` is the model's fur_area.
std::vector<GrowRecipe> recipes_of(const FurFrame& frame, bool has_colours, double area);

/// Compact parts of at most `strands_each` strands of all coats together, or of one piece.
std::vector<StrandChunk> make_chunks(const FurModel& model, EachCoat<Coat> coats, double strands_each);

/// Returns how many strands to expect of the whole fur, before density, bare skin and `share` reduce their number.
double expected_strands(const FurModel& model, const Coat& coat);

/// A corner of a piece of skin, as it looks between strands.
struct SkinLook {
  glm::vec3 under{0};           // colour under fur, linear
  float grown = 0;              // share that has that colour, [0, 1]; the rest has the model's own
  float bare = 0, wetness = 0;  // painted, [0, 1]
};

/// Returns the look of skin between the strands of several coats.
std::array<SkinLook, 3> skin_under(std::span<const std::array<SkinLook, 3>> of_each);

/// What strands of a coat share, wherever they stand.
struct CoatTables;
/// Returns the curves in which the coat leans.
const LeanTable& leans_of(const CoatTables& tables);

/// Prepared once for a state of the fields; then asked for chunks, from any thread. The model's views must outlive it.
/// Deterministic: the same strands whatever the chunks are and whoever asks. A strand of n segments takes 20 (n + 1) +
/// 44 bytes; n is 6 for straight ones and up to 48 for curls and waves (strand_segments in tile_strands.h).
///
/// Where shells repeat a tile that was made for fur of one length, strands of shorter fur go to the side by no more
/// than they are long. A share below 1/16 also leaves out whole strands of the tile, down to 256 of them, so that about
/// 16 copies at most are examined for each strand that grows. Limits: a piece grows at most 4,194,304 strands,
/// and none where its place on the tile is further than 100 sizes from the origin or has no area (TileCells); who must
/// bound memory asks expected_strands first.
class Grower {
 public:
  /// `before` is what another one had prepared: what it shares with this one is not prepared again.
  Grower(const FurModel& model, const FurFields& fields, const GrowRecipe& recipe,
         std::shared_ptr<const CoatTables> before = nullptr);
  ~Grower();

  /// Returns the strands of a chunk; if they would take more than `max` bytes, only some of them, which also exceed
  /// `max`. Fur of no length grows none; density keeps the strands whose number is below it. A radius is never below
  /// 1e-7, so that nothing is divided by 0 where strands have no width.
  StrandSet grow(const StrandChunk& chunk, std::size_t max = std::numeric_limits<std::size_t>::max()) const;
  /// Moves strands that grew from a chunk, from where `still` has them to where `direction` leads (FurFields::still,
  /// not empty).
  void bend(const StrandChunk& chunk, StrandSet& set) const;
  /// Returns what `bend` moves the strands of a piece by.
  PieceBend bend_of(std::uint32_t piece) const;
  /// Returns the curves in which strands lean.
  const LeanTable& leans() const;
  /// Returns the look of the skin at the corners of a piece.
  std::array<SkinLook, 3> skin(std::uint32_t piece) const;
  /// Returns a 64-bit fingerprint of all that `grow(chunk)` and `skin` of its pieces depend on. It stays the same while
  /// they would give the same result.
  std::uint64_t fingerprint(const StrandChunk& chunk) const;
  /// Returns a fingerprint of what `bend(chunk)` depends on besides; 0 where nothing is bent.
  std::uint64_t bend_fingerprint(const StrandChunk& chunk) const;
  const std::shared_ptr<const CoatTables>& tables() const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

/// Whiskers, lashes and brows (renderer/curves) as strands; all stand clear of the fur's ramp and fields.
StrandSet grow_curves(std::span<const FurCurves> curves);

}  // namespace pelage
