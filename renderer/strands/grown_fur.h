// The strands of all coats and the curves as they stand, in parts that grow again only where something changed.
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
  CoatId coat = 0;
  float crowding = 1;       // what strands cover over what the whole first coat does on that area; 0 for curves
  float wider = 1;          // than those of the whole coat, where a share of it was grown
  float unwound = 1;        // how little curls and waves wind them over those of the first coat, square root
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
  /// Fur of several coats is always bent.
  std::size_t update(const FurModel& model, EachCoat<FurFields> fields, EachCoat<GrowRecipe> recipes, int threads,
                     std::span<const FurCurves> curves = {}, Bending bending = Bending::done);

  const std::vector<GrownPart>& parts() const { return parts_; }
  /// Returns how the parts are to be bent, if that was left to the caller.
  FurBend bend() const;
  /// Returns the look of the skin at the corners of each piece of the model.
  const std::vector<std::array<SkinLook, 3>>& skin() const { return coats_.size() == 1 ? coats_.front().skin : skin_; }
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

  /// What is kept of a coat.
  struct GrownCoat {
    // What the surface was divided for:
    CoatId id = 0;
    double count = 0, tile = 0, share = 0;
    std::shared_ptr<const CoatTables> tables;
    std::vector<PieceBend> bends;  // of each piece; empty where nothing moves
    std::vector<std::array<SkinLook, 3>> skin;
  };
  /// A coat as it is to grow.
  struct Growing {
    const FurModel& model;
    const Grower& grower;
    const GrowRecipe& recipe;
    Bending bending;
    std::size_t coat;
    double cover, unwound;  // over those of the first coat
  };

  bool divided_for(const FurModel& model, EachCoat<FurFields> fields, EachCoat<GrowRecipe> recipes) const;
  void divide(const FurModel& model, EachCoat<FurFields> fields, EachCoat<GrowRecipe> recipes);
  std::size_t part_of(std::size_t coat, std::size_t chunk) const { return coat * chunks_.size() + chunk; }
  std::size_t grow_part(const Growing& how, std::size_t chunk);
  std::size_t grow_still(const Growing& how, std::size_t chunk);
  void bend_part(const Growing& how, std::size_t chunk);
  std::size_t set_curves(std::span<const FurCurves> curves);
  void join_skin();

  std::uint64_t model_ = 0;
  std::vector<StrandChunk> chunks_;  // of all coats together
  std::vector<GrownCoat> coats_;
  std::vector<FurCurves> curves_;
  std::vector<GrownPart> parts_;               // of each coat and chunk, then that of the curves
  std::vector<Still> still_;                   // of each coat and chunk
  std::vector<std::array<SkinLook, 3>> skin_;  // between several coats
};

}  // namespace pelage
