#include "server/scene/scene_memory.h"

#include "server/scene/scene.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace pelage {

std::size_t bytes_of(const SceneModel& model) {
  std::size_t bytes = sizeof(SceneModel) + model.surface.bytes();
  bytes += model.patches.points.capacity() * sizeof(PatchPoint) +
           model.patches.patch_triangles.capacity() * sizeof(PatchTriangle);
  for (const ChosenTriangles& chosen : model.subdivisions) bytes += chosen.capacity() * sizeof(TriangleRun);
  return bytes;
}

SceneMemory Scene::memory() const noexcept {
  const std::lock_guard lock(mutex_);
  std::size_t own = sizeof(Scene) + present_->fields->bytes() + history_.bytes();  // recent changes are small
  if (present_->skin_texture) own += present_->skin_texture->rgba.capacity();
  const SceneModel& model = *present_->model;
  return {own, model.id, bytes_of(model), present_->copy_id, live_.is_live()};
}

void trim_allocator() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

void limit_arenas() {
#ifdef __GLIBC__
  mallopt(M_ARENA_MAX, 2);
#endif
}

}  // namespace pelage
