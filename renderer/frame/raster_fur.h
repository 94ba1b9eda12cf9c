// Caches grown fur for each model, so that after a stroke only the parts that it changed grow again.
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

/// Share of a coat that grows for drafts that draw no more of it; it takes a third of the time.
inline constexpr double thin_share = 0.34;

/// A model's fur as it was last drawn, with all of its strands or a share of them.
struct RasterFur {
  RasterFur(const ModelCopy& of, double share, int threads, const std::shared_ptr<RasterScratch>& scratch)
      : copy(of), share_of_coat(share), raster(std::make_unique<Raster>(threads, scratch)) {}

  const ModelCopy& copy;
  double share_of_coat;
  GrownFur fur;
  std::unique_ptr<Raster> raster;
  // From what the fur was grown:
  std::vector<GrowRecipe> recipes;  // for each coat; empty if nothing has grown
  std::uint64_t changes = 0;        // ModelCopy::changes
  std::vector<FurCurves> curves;
  Bending bending = Bending::left;

  /// Grows what has changed since the last call.
  void grow(std::vector<GrowRecipe> wanted, std::span<const FurCurves> with, Bending how, int threads);
  /// Frees the fur and the shadow cells.
  void drop(int threads, const std::shared_ptr<RasterScratch>& scratch);
  std::size_t bytes() const { return fur.bytes() + raster->bytes(); }
};

/// What is cached for a model.
struct RasterModel {
  RasterModel(const FurModel& model, EachCoat<FurFields> fields, int threads,
              const std::shared_ptr<RasterScratch>& scratch);

  ModelCopy copy;
  double fur_area;         // pelage::fur_area of the model, sizes^2
  std::uint64_t used = 0;  // when it was last used: RasterRenderer::uses_ then
  RasterFur full, thin;

  std::vector<GrowRecipe> recipes_for(const FurFrame& frame) const;
  /// Returns for each vertex what the frame's overlay shows, which has to be a field.
  std::vector<glm::vec3> field_of(const FurFrame& frame) const;
  bool is_grown() const { return !full.recipes.empty() || !thin.recipes.empty(); }
  void drop(int threads, const std::shared_ptr<RasterScratch>& scratch);
  /// Returns the bytes that drop() would free.
  std::size_t grown_bytes() const { return full.bytes() + thin.bytes(); }
};

}  // namespace pelage
