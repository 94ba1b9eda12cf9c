// Computes on the GPU what shadows a scene, and again only what has changed: the bent strands, their density in the
// cells of a grid, what each light crosses on its way to each cell, and how much of the sky is hidden from the ground.
// The results correspond to GrownFur's bent strands, DensityGrid, NearCells and SkyOverGround.
#pragma once

#include <cstdint>
#include <vector>

#include "renderer/raster/gpu/gpu_model.h"
#include "renderer/raster/gpu/stages.h"
#include "renderer/raster/gpu/strand_pool.h"

namespace pelage {

/// FurPart of fur.glsl, which describes the members.
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

  /// Determines what has changed in a scene, and sends it. `strands_changed`: the strands of the pool have changed.
  void prepare(const RasterScene& scene, const StrandPool& pool, bool strands_changed);
  /// Computes what depends on the changes that prepare() found; the scene's uniforms must have been sent. Returns false
  /// if a stage cannot be built.
  bool find(Stages& stages, const RasterScene& scene, const StrandPool& pool, const GpuModel& model);

  /// Returns the points of all strands, bent where something bends them.
  const Storage& points(const StrandPool& pool) const { return bends_.empty() ? pool.points() : bent_; }
  std::uint32_t groups() const { return groups_; }
  bool has_near() const { return !near_parts_.empty(); }

  // Buffers that the drawing stages read: the CrossedCells, NearCells and Sky of the shaders.
  Storage crossed, near, sky;

 private:
  /// What has to be computed again.
  struct Stale {
    bool strands = true, light = true, near = true, sky = true;
  };

  bool take_bend(const FurBend& bend);
  void send_list(const RasterScene& scene, const StrandPool& pool);
  bool bend(Stages& stages, const StrandPool& pool);
  bool add_strands(Stages& stages, const RasterScene& scene, const StrandPool& pool);
  bool update_lights(Stages& stages, const RasterScene& scene, const GpuModel& model);
  bool add_near(Stages& stages, const StrandPool& pool);
  bool find_sky(Stages& stages, const RasterScene& scene, const GpuModel& model);

  Stale stale_;
  std::uint64_t model_ = 0;
  GridLayout layout_;
  std::vector<TriangleBend> bends_;
  std::vector<LeanRow> leans_;
  std::vector<FurLight> lights_;
  std::vector<std::uint32_t> near_parts_;
  float ground_height_ = 0;
  std::uint32_t groups_ = 0;
  Storage list_groups_, list_parts_, bends_sent_, leans_sent_, bent_;
  Storage cell_sums_, body_sums_, within_, through_, columns_;
};

}  // namespace pelage
