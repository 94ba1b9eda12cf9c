// The strands of all coats and the curves, in parts; only parts that changed are grown again.
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
  curve,  // a single whisker, lash or brow hair outside of the coat
};

/// Strands that grow on one chunk of the surface, or all curves.
struct GrownPart {
  StrandRole role = StrandRole::coat;
  std::shared_ptr<const StrandSet> strands;  // never null
  glm::vec3 low{0}, high{0};                 // bounding box of the skin and of the strands with their thickness, sizes
  glm::vec3 middle{0};                       // centre of the skin's bounding box, sizes
  float radius = 0;                          // radius of a sphere about `middle` that contains the skin, sizes
  float longest = 0;                         // bound of strand lengths, sizes; rounded up, so strokes seldom change it
  float thickest = 0;                        // largest radius of all strands that have ever grown in this part, sizes
  double area = 0;                           // area of the skin under the part, sizes^2
  CoatId coat = 0;
  float crowding = 1;       // coverage relative to the first coat at full density on that area; 0 for curves
  float wider = 1;          // widening relative to the full coat, if only a share of its strands was grown
  float unwound = 1;        // square root of the first coat's winding over this coat's
  float packing = 0;        // share of the skin that the full coat's strands fill, over their radius^2
  std::uint64_t state = 0;  // changes with the strands
  std::uint64_t skin = 0;   // changes with the look of the skin
};

/// The bending by which a caller moves strands from where they have grown.
struct FurBend {
  std::span<const TriangleBend> triangles;  // for each triangle of the model; empty if nothing moves them
  std::span<const LeanRow> leans;           // the table of curves along which strands lean: LeanTable::rows
};

/// `done`: strands come out bent. `left`: the caller bends them by a FurBend.
enum class Bending { done, left };

class GrownFur {
 public:
  /// Grows the parts that have changed, on up to `threads` threads. Returns the number of strands that were grown. The
  /// views are not stored. Fur of several coats is always bent.
  std::size_t update(const FurModel& model, EachCoat<FurFields> fields, EachCoat<GrowRecipe> recipes, int threads,
                     std::span<const FurCurves> curves = {}, Bending bending = Bending::done);

  const std::vector<GrownPart>& parts() const { return parts_; }
  /// Returns how the caller has to bend the parts, if that was left to the caller.
  FurBend bend() const;
  /// Returns the look of the skin at the corners of each triangle of the model.
  const std::vector<std::array<SkinLook, 3>>& skin() const { return coats_.size() == 1 ? coats_.front().skin : skin_; }
  std::size_t count() const;
  std::size_t bytes() const;

 private:
  /// A part's strands and bounding box before wind or body moves them.
  struct Still {
    std::shared_ptr<const StrandSet> strands;
    std::uint64_t state = 0;
    glm::vec3 low{0}, high{0};
    float stretch = 1;  // largest StrandRoot::stretch
  };

  /// The cached state of a coat.
  struct GrownCoat {
    // The surface was divided into chunks for these:
    CoatId id = 0;
    double count = 0, tile = 0, share = 0;
    std::shared_ptr<const CoatTables> tables;
    std::vector<TriangleBend> bends;  // for each triangle; empty if nothing moves the fur
    std::vector<std::array<SkinLook, 3>> skin;
  };
  /// The inputs for growing one coat.
  struct Growing {
    const FurModel& model;
    const Grower& grower;
    const GrowRecipe& recipe;
    Bending bending;
    std::size_t coat;
    double cover, unwound;  // GrownPart::crowding of the full coat; GrownPart::unwound
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
  std::vector<StrandChunk> chunks_;  // shared by all coats
  std::vector<GrownCoat> coats_;
  std::vector<FurCurves> curves_;
  std::vector<GrownPart> parts_;               // for each coat and chunk; the last one has the curves
  std::vector<Still> still_;                   // for each coat and chunk
  std::vector<std::array<SkinLook, 3>> skin_;  // look of the skin under several coats together; unused for one coat
};

}  // namespace pelage
