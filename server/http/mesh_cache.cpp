#include "server/http/mesh_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>
namespace pelage {

namespace {

/// Limits the number of triangles to the model's own: more give the same mesh.
std::size_t clamped_triangles(const SceneModel& model, int triangles) {
  return std::min(model.surface.mesh().triangles.size(), static_cast<std::size_t>(triangles));
}

}  // namespace

std::uint64_t MeshCache::new_process_stamp() {
  return static_cast<std::uint64_t>(std::chrono::system_clock::now().time_since_epoch().count());
}

std::string MeshCache::etag_of(const SceneSnapshot& scene, const MeshRequest& wanted) const {
  const std::string fur = wanted.fur ? fmt::format(".{}", scene.revision) : "";
  return fmt::format("\"{:x}.{}.{}{}\"", process_stamp_, scene.model->id,
                     clamped_triangles(*scene.model, wanted.triangles), fur);
}

std::shared_ptr<MeshCache::Entry> MeshCache::entry_of(const std::shared_ptr<const SceneModel>& model,
                                                      std::size_t triangles) {
  const std::lock_guard lock(mutex_);
  entries_.remove_if([](const auto& entry) { return entry->model.expired(); });
  const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) {
    return entry->model_id == model->id && entry->triangles == triangles;
  });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
  } else {
    entries_.push_front(std::make_shared<Entry>(model, model->id, triangles));
    if (entries_.size() > max_entries) entries_.pop_back();
  }
  return entries_.front();
}

Result<MeshCache::MeshPtr> MeshCache::mesh(const std::shared_ptr<const SceneModel>& model, int triangles) {
  const std::shared_ptr<Entry> entry = entry_of(model, clamped_triangles(*model, triangles));
  const std::lock_guard lock(entry->making);
  if (entry->mesh) return entry->mesh;
  const auto pass = simplifying_.enter();
  if (!pass) return failure(Code::unavailable, "Too many meshes are being made.", "", "4 at a time");
  Result<ProxyMesh> proxy = simplify(model->surface.mesh(), entry->triangles);
  if (!proxy) return proxy.status();
  entry->mesh = std::make_shared<const ProxyMesh>(std::move(*proxy));
  return entry->mesh;
}

}  // namespace pelage
