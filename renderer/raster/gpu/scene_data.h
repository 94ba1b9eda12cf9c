// A scene on the GPU, which all stages of a box read. Parts are sent again if they have changed.
#pragma once

#include "renderer/gl/handles.h"
#include "renderer/raster/gpu/fur_cells.h"
#include "renderer/raster/gpu/gpu_model.h"
#include "renderer/raster/gpu/scene_block.h"
#include "renderer/raster/gpu/storage.h"
#include "renderer/raster/gpu/strand_plan.h"
#include "renderer/raster/gpu/strand_pool.h"

namespace pelage {

/// The buffer of a uniform block.
class Uniforms {
 public:
  explicit Uniforms(const Gl& gl) : gl_(gl), buffer_(gl) {}

  template <class Block>
  void send(int binding, const Block& block) {
    gl_.NamedBufferData(buffer_.id(), sizeof(Block), &block, GL_DYNAMIC_DRAW);
    gl_.BindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), buffer_.id());
  }

 private:
  const Gl& gl_;
  Buffer buffer_;
};

/// A box of a scene's picture that is being drawn.
struct DrawnBox {
  const RasterScene& scene;
  const PixelBox& pixels;
  const StrandPlan& strands;
  TileRows tiles;

  std::size_t groups() const { return strands.groups.size(); }
  glm::ivec2 grid() const { return {tiles.across, tiles.down}; }
};

class SceneData {
 public:
  explicit SceneData(const Gl& gl)
      : pool(gl),
        model(gl),
        cells(gl),
        plan(gl),
        azimuthal(gl),
        eyes(gl),
        tissues(gl),
        caustics(gl),
        drawn(gl),
        frame_(gl),
        scattering_(gl),
        skin_(gl),
        scene_(gl) {}

  /// Sends the strands of a scene. Call it before the plan is made, which refers to them.
  void send_strands(const RasterScene& scene) { strands_changed_ = pool.update(scene.parts) || strands_changed_; }
  /// Sends everything else but the plan and the capacities.
  void send(const DrawnBox& box);
  void send_plan(const StrandPlan& strands);
  void send_capacities(const DrawnBox& box, const StageCapacities& rooms) {
    SceneBlock block = scene_block(box.scene, box.pixels, box.strands.strands(), rooms);
    block.fur_groups = cells.groups(), block.near_there = cells.has_near();
    scene_.send(raster_binding, block);
  }

  StrandPool pool;
  GpuModel model;
  FurCells cells;
  Storage plan, azimuthal, eyes, tissues, caustics;
  Storage drawn;  // for each tile of the box, 1 if it is to be drawn, else 0

 private:
  void send_azimuthal(const AzimuthalFit& fit);
  void send_eyes(const EyeOptics& optics);

  Uniforms frame_, scattering_, skin_, scene_;
  bool strands_changed_ = true;  // since the last send()
};

}  // namespace pelage
