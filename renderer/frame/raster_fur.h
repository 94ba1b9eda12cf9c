// Fur that has grown, kept for each model, so that a stroke grows its part alone.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "renderer/raster/model_copy.h"
#include "renderer/raster/raster.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// The share of a coat that is enough for drafts which keep no more of it: it grows in a third of the time.
inline constexpr double thin_share = 0.34;

/// A model's fur as it stood when it was drawn last, or a share of its strands.
struct RasterFur {
  RasterFur(const ModelCopy& of, double share, int threads, const std::shared_ptr<RasterRoom>& room)
      : copy(of), share_of_coat(share), raster(std::make_unique<Raster>(threads, room)) {}

  const ModelCopy& copy;
  double share_of_coat;
  GrownFur fur;
  std::unique_ptr<Raster> raster;
  // What the fur was grown of:
  std::vector<GrowRecipe> recipes;  // of each coat; empty before the first
  std::uint64_t changes = 0;
  std::vector<FurCurves> curves;
  Bending bending = Bending::left;

  /// Grows what is not as it was.
  void grow(std::vector<GrowRecipe> wanted, std::span<const FurCurves> with, Bending how, int threads);
  void drop(int threads, const std::shared_ptr<RasterRoom>& room);
  std::size_t bytes() const { return fur.bytes() + raster->bytes(); }
};

/// What is kept of a model.
struct RasterModel {
  RasterModel(const FurModel& model, EachCoat<FurFields> fields, int threads, const std::shared_ptr<RasterRoom>& room);

  ModelCopy copy;
  double fur_area;  // of the model
  std::uint64_t used = 0;
  RasterFur whole, thin;

  std::vector<GrowRecipe> recipes_for(const FurFrame& frame) const;
  /// Of each vertex what the frame's overlay shows.
  std::vector<glm::vec3> field_of(const FurFrame& frame) const;
  bool is_grown() const { return !whole.recipes.empty() || !thin.recipes.empty(); }
  void drop(int threads, const std::shared_ptr<RasterRoom>& room);
  /// That a drop would free.
  std::size_t grown_bytes() const { return whole.bytes() + thin.bytes(); }
};

}  // namespace pelage
