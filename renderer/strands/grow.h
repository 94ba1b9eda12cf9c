// Strands from the groom: every strand of the sample tile wherever the tile lies on the surface. What shells read from
// slices, fields, tufts, patterns and paint (renderer/shaders), strands have as geometry.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/strands/strand_set.h"

namespace pelage {

/// What says how strands grow beside the model and its fields.
struct GrowRecipe {
  Coat coat;
  bool model_colours = false;  // hue from the model, lightness from the ramp (base_colour.glsl)
  double share = 1;            // of the strands that grow, by a number of their own, (0, 1]
  double widening = 1;         // factor on their width, >= 1: 1 / share keeps what they cover

  bool operator==(const GrowRecipe&) const = default;
};

/// A part of the surface that is grown at a time: indices of the model's pieces that lie together.
using StrandChunk = std::vector<std::uint32_t>;

/// Pieces sorted along a space-filling curve and cut where about `strands_each` strands are reached.
std::vector<StrandChunk> make_chunks(const FurModel& model, const Coat& coat, std::size_t strands_each);

/// Strands of whole fur, before density, bare skin and `share`: what says how many are to be expected.
double expected_strands(const FurModel& model, const Coat& coat);

/// Prepared once for a state of the fields; then asked for chunks, from any thread. The views must outlive it.
/// Deterministic: the same strands whatever the chunks are and whoever asks.
class Grower {
 public:
  Grower(const FurModel& model, const FurFields& fields, const GrowRecipe& recipe);
  ~Grower();

  /// The strands of a chunk. Fur of no length grows none, density keeps those whose number is below it.
  StrandSet grow(const StrandChunk& chunk) const;
  /// Of all that `grow(chunk)` depends on: the same while it would give the same strands. 64 bits.
  std::uint64_t fingerprint(const StrandChunk& chunk) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

/// Whiskers, lashes and brows (renderer/curves) as strands; all stand clear of the fur's ramp and fields.
StrandSet grow_curves(std::span<const FurCurves> curves);

}  // namespace pelage
