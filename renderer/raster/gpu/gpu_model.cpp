#include "renderer/raster/gpu/gpu_model.h"

#include <cstring>
#include <span>

namespace pelage {

void GpuModel::update(const RasterScene& scene) {
  if (model_ != scene.model->id) {
    send_shape(*scene.model);
    model_ = scene.model->id, images_ = nullptr;
  }
  send_looks(scene);
  const BaseImages* images = scene.optics.images;
  if (images && images_ != images) send_texels(*images);
  images_ = images;
  field.send(scene.field);
}

void GpuModel::send_shape(const FurModel& model) {
  std::vector<glm::vec3> of_vertices;
  for (std::size_t v = 0; v < model.positions.size(); ++v) {
    of_vertices.push_back(model.positions[v]);
    of_vertices.push_back(model.normals[v]);
  }
  vertices.send(std::span<const glm::vec3>(of_vertices));
  triangles.send(model.triangles), corners.send(model.corners);
}

void GpuModel::send_looks(const RasterScene& scene) {
  const bool same =
      sent_looks_.size() == scene.skin.size() &&
      (scene.skin.empty() || std::memcmp(sent_looks_.data(), scene.skin.data(), scene.skin.size_bytes()) == 0);
  if (same) return;
  sent_looks_.assign(scene.skin.begin(), scene.skin.end());
  looks.send(scene.skin);
}

void GpuModel::send_texels(const BaseImages& images) {
  static_assert(sizeof(BaseImages::Level) == 3 * sizeof(std::int32_t));
  std::vector<std::int32_t> sent;
  for (const BaseImages::Level& level : images.levels)
    sent.insert(sent.end(), {level.width, level.height, level.first});
  sent.insert(sent.end(), images.texels.begin(), images.texels.end());
  texels.send(std::span<const std::int32_t>(sent));
}

}  // namespace pelage
