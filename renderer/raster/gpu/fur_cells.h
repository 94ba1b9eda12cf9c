// What stands in the way of a scene's light, found on the GPU where it is another: strands that something bends, how
// densely they stand in the cells of a grid, what each light crosses on its way there, and how much the ground sees of
// the sky. The same as GrownFur's bent strands, DensityGrid, NearCells and SkyOverGround.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/raster/gpu/gpu_model.h"
#include "renderer/raster/gpu/stages.h"
#include "renderer/raster/gpu/strand_pool.h"

namespace pelage {

/// As fur.glsl has it.
struct FurListPart {
  std::uint32_t points = 0, words = 0, count = 0, summed = 0;
  std::int32_t segments = 1;
  float each = 1;
  std::uint32_t near = 0, unused = 0;
};
static_assert(sizeof(FurListPart) == 32);

class FurCells {
 public:
  explicit FurCells(const Gl& gl);

  /// Sees what of a scene is another than it was, and sends it. `strands_changed`: those of the pool are others.
  void prepare(const RasterScene& scene, const StrandPool& pool, bool strands_changed);
  /// Finds anew what depends on that; the scene's uniforms are sent. False where a stage cannot be built.
  bool find(Stages& stages, const RasterScene& scene, const StrandPool& pool, const GpuModel& model);

  /// Of all strands, as they stand.
  const Storage& points(const StrandPool& pool) const { return bends_.empty() ? pool.points() : bent_; }
  std::uint32_t groups() const { return groups_; }
  bool has_near() const { return !near_parts_.empty(); }

  // As the stages read them.
  Storage crossed, near, sky;

 private:
  /// What is to be found anew.
  struct Stale {
    bool strands = true, light = true, near = true, sky = true;
  };

  bool take_bend(const FurBend& bend);
  void send_list(const RasterScene& scene, const StrandPool& pool);
  bool bend(Stages& stages, const StrandPool& pool);
  bool add_strands(Stages& stages, const RasterScene& scene, const StrandPool& pool);
  bool follow_lights(Stages& stages, const RasterScene& scene, const GpuModel& model);
  bool add_near(Stages& stages, const StrandPool& pool);
  bool find_sky(Stages& stages, const RasterScene& scene, const GpuModel& model);

  Stale stale_;
  std::uint64_t model_ = 0;
  GridPlace place_;
  std::vector<PieceBend> bends_;
  std::vector<LeanRow> leans_;
  std::vector<FurLight> lights_;
  std::vector<std::uint32_t> near_parts_;
  float ground_height_ = 0;
  std::uint32_t groups_ = 0;
  Storage list_groups_, list_parts_, bends_sent_, leans_sent_, bent_;
  Storage cell_sums_, body_sums_, within_, through_, columns_;
};

}  // namespace pelage
