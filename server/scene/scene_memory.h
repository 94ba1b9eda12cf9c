// Estimates of a scene's memory, and allocator settings that return freed memory to the system.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pelage {

struct SceneModel;
struct SceneSettings;

/// Estimates in bytes, without the renderer's copy (OpenScenes::count_copies). Branches may share a model.
struct SceneMemory {
  std::size_t own = 0;         // fields, undo log, settings and skin texture
  std::uint64_t model_id = 0;  // SceneModel::id
  std::size_t model = 0;
  std::uint64_t copy_id = 0;  // SceneView::copy_id
  bool in_stroke = false;     // a stroke that arrives in parts has not ended
};

std::size_t bytes_of(const SceneModel& model);

/// Makes the allocator return the freed memory that it holds to the system. Called after a scene is evicted and after a
/// model is prepared, which takes several times the model's own memory.
void trim_allocator();

/// Limits the allocator to two arenas, so that memory freed by threads can be returned to the system. Must be called
/// before any thread starts. With an arena for each thread the server stays a sixth larger after scenes are removed.
void limit_arenas();

}  // namespace pelage
