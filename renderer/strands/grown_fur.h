// The strands of a whole coat and its curves as they stand, in parts that grow again only where something changed.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/strands/grow.h"

namespace pelage {

enum class StrandRole {
  coat,
  curve,  // a whisker, a lash, a hair of a brow: single, and clear of the coat
};

/// Strands that stand together.
struct GrownPart {
  StrandRole role = StrandRole::coat;
  std::shared_ptr<const StrandSet> strands;  // never null
  glm::vec3 low{0}, high{0};                 // around their skin and all of them with their thickness, sizes
  glm::vec3 middle{0};                       // of the skin, sizes
  float radius = 0;                          // of a ball about `middle` that holds it, sizes
  float longest = 0;                         // bound of their lengths, in steps that a stroke seldom changes, sizes
  float thickest = 0;                        // largest radius of all strands that have stood there, sizes
  double area = 0;                           // of the skin that they stand on, sizes^2
  float crowding = 1;                        // strands over those of the whole coat on that area; 0 for curves
  float wider = 1;                           // than those of the whole coat, where a share of it was grown
  float packing = 0;        // share of the skin that strands of the whole coat fill, over their radius^2
  std::uint64_t state = 0;  // the same while the strands are
  std::uint64_t skin = 0;   // the same while the looks of its skin are
};

/// What moves strands from where they have grown.
struct FurBend {
  std::span<const PieceBend> pieces;  // of each piece of the model; empty: nothing moves them
  std::span<const LeanRow> leans;     // in which they lean: LeanTable::rows
};

/// Whether strands are bent already, or left to a caller that bends them by a FurBend.
enum class Bending { done, left };

class GrownFur {
 public:
  /// Grows what has changed, on up to `threads` threads. Returns the number of strands that were grown. The views are
  /// not stored.
  std::size_t update(const FurModel& model, const FurFields& fields, const GrowRecipe& recipe, int threads,
                     std::span<const FurCurves> curves = {}, Bending bending = Bending::done);

  const std::vector<GrownPart>& parts() const { return parts_; }
  /// Returns how the parts are to be bent, if that was left to the caller.
  FurBend bend() const { return {bends_, leans_ ? leans_->rows() : std::span<const LeanRow>()}; }
  /// Returns the look of the skin at the corners of each piece of the model.
  const std::vector<std::array<SkinLook, 3>>& skin() const { return skin_; }
  std::size_t count() const;
  std::size_t bytes() const;

 private:
  /// A part's strands before anything moves them, and what is around them.
  struct Still {
    std::shared_ptr<const StrandSet> strands;
    std::uint64_t state = 0;
    glm::vec3 low{0}, high{0};
    float stretch = 1;  // largest of their roots'
  };

  void divide(const FurModel& model, const GrowRecipe& recipe);
  std::size_t grow_part(const FurModel& model, const Grower& grower, const GrowRecipe& recipe, Bending bending,
                        std::size_t chunk);
  std::size_t grow_still(const FurModel& model, const Grower& grower, const GrowRecipe& recipe, std::size_t chunk);
  void bend_part(const Grower& grower, Bending bending, std::size_t chunk);
  std::size_t set_curves(std::span<const FurCurves> curves);

  std::uint64_t model_ = 0;
  double count_ = 0, tile_ = 0, share_ = 0;  // of the recipe that the surface was divided for
  std::shared_ptr<const CoatTables> tables_;
  std::vector<StrandChunk> chunks_;
  std::vector<FurCurves> curves_;
  std::vector<GrownPart> parts_;  // of each chunk, then that of the curves
  std::vector<Still> still_;      // of each chunk
  std::vector<PieceBend> bends_;  // of each piece; empty where nothing moves
  std::shared_ptr<const LeanTable> leans_;
  std::vector<std::array<SkinLook, 3>> skin_;
};

}  // namespace pelage
