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
  send_grid(scene);
  if (scene.sky) sky.send(std::span<const float>(scene.sky->hidden));
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
      held_looks_.size() == scene.skin.size() &&
      (scene.skin.empty() || std::memcmp(held_looks_.data(), scene.skin.data(), scene.skin.size_bytes()) == 0);
  if (same) return;
  held_looks_.assign(scene.skin.begin(), scene.skin.end());
  looks.send(scene.skin);
}

void GpuModel::send_texels(const BaseImages& images) {
  static_assert(sizeof(BaseImages::Level) == 3 * sizeof(std::int32_t));
  std::vector<std::int32_t> words;
  for (const BaseImages::Level& level : images.levels)
    words.insert(words.end(), {level.width, level.height, level.first});
  words.insert(words.end(), images.texels.begin(), images.texels.end());
  texels.send(std::span<const std::int32_t>(words));
}

void GpuModel::send_grid(const RasterScene& scene) {
  if (!scene.grid) return;
  const auto lights = static_cast<std::size_t>(scene.optics.lights);
  if (grid_ != scene.grid || grid_version_ != scene.grid->version()) {
    crossed.reserve(std::max<std::size_t>(lights * scene.grid->place().count() * sizeof(Crossed), 16));
    for (std::size_t light = 0; light < lights; ++light)
      crossed.send_at(light * scene.grid->place().count() * sizeof(Crossed), scene.grid->crossed(light));
    grid_ = scene.grid, grid_version_ = scene.grid->version();
  }
  if (!scene.near || scene.near->cells().empty()) return;
  if (near_ == scene.near && near_since_ == scene.near->since()) return;
  near.send(scene.near->cells());
  near_ = scene.near, near_since_ = scene.near->since();
}

}  // namespace pelage
