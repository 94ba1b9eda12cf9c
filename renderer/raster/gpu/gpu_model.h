// A model's surface on the GPU, and the light of its grid: sent where they are others.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/raster/gpu/storage.h"
#include "renderer/raster/raster_scene.h"

namespace pelage {

class GpuModel {
 public:
  explicit GpuModel(const Gl& gl)
      : vertices(gl), triangles(gl), corners(gl), looks(gl), texels(gl), field(gl), crossed(gl), near(gl), sky(gl) {}

  /// `strands_changed`: those of the scene are not the ones that were there, and so its cells may be others.
  void update(const RasterScene& scene, bool strands_changed);

  // As the stages read them.
  Storage vertices, triangles, corners, looks, texels, field, crossed, near, sky;

 private:
  void send_shape(const FurModel& model);
  void send_looks(const RasterScene& scene);
  void send_texels(const BaseImages& images);
  void send_grid(const RasterScene& scene, bool strands_changed);

  std::uint64_t model_ = 0;
  const BaseImages* images_ = nullptr;
  std::vector<std::array<SkinLook, 3>> held_looks_;
  std::uint64_t crossed_version_ = 0, near_fills_ = 0;
  std::size_t lights_ = 0;
};

}  // namespace pelage
