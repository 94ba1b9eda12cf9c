// A cache of the simplified meshes that clients asked for most recently.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "base/status.h"
#include "server/export/proxy_mesh.h"
#include "server/http/guard.h"
#include "server/scene/scene.h"

namespace pelage {

/// Thread-safe. Clients that ask for the same mesh wait for one simplification. An entry is evicted when its model is
/// gone (checked at the next call) or `max_entries` others have been asked for since.
class MeshCache {
 public:
  using MeshPtr = std::shared_ptr<const ProxyMesh>;

  /// Returns a strong entity tag with its quotes, unique for the process, the model and the number of triangles; with
  /// fur also for the revision.
  std::string etag_of(const SceneSnapshot& scene, const MeshRequest& wanted) const;

  /// Returns a mesh with at most `triangles` triangles. Fails as simplify does, and with unavailable while too many
  /// other meshes are being made.
  Result<MeshPtr> mesh(const std::shared_ptr<const SceneModel>& model, int triangles);

 private:
  struct Entry {
    std::weak_ptr<const SceneModel> model;
    std::uint64_t model_id;
    std::size_t triangles;
    std::mutex making = {};  // held while `mesh` is made
    MeshPtr mesh = {};

    Entry(std::weak_ptr<const SceneModel> of, std::uint64_t id, std::size_t wanted)
        : model(std::move(of)), model_id(id), triangles(wanted) {}
  };

  std::shared_ptr<Entry> entry_of(const std::shared_ptr<const SceneModel>& model, std::size_t triangles);

  static constexpr std::size_t max_entries = 8;

  const std::uint64_t process_stamp_ = new_process_stamp();
  static std::uint64_t new_process_stamp();
  std::mutex mutex_;
  std::list<std::shared_ptr<Entry>> entries_;  // most recently used first
  Gate simplifying_{4};                        // each run takes a core and up to a few hundred MB
};

}  // namespace pelage
