// A model's surface on the GPU: its shape, colours and fields. Parts are sent again if they have changed.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "renderer/raster/gpu/storage.h"
#include "renderer/raster/raster_scene.h"

namespace pelage {

class GpuModel {
 public:
  explicit GpuModel(const Gl& gl) : vertices(gl), triangles(gl), corners(gl), looks(gl), texels(gl), field(gl) {}

  void update(const RasterScene& scene);

  // Buffers that the stages read, under the shaders' names.
  Storage vertices, triangles, corners, looks, texels, field;

 private:
  void send_shape(const FurModel& model);
  void send_looks(const RasterScene& scene);
  void send_texels(const BaseImages& images);

  std::uint64_t model_ = 0;
  const BaseImages* images_ = nullptr;
  std::vector<std::array<SkinLook, 3>> sent_looks_;
};

}  // namespace pelage
