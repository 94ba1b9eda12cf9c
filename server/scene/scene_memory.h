// The memory that a scene takes, and the allocator settings that return freed memory to the system.
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
  bool in_stroke = false;     // a stroke that comes in parts has not ended
};

std::size_t bytes_of(const SceneModel& model);

/// Makes the allocator return freed memory, which it holds back for others, to the system: after a scene is evicted,
/// and after a model is prepared, which takes several times the model's own memory.
void give_memory_back();

/// Keeps the allocator to two arenas, so that what threads free can be given back; before any thread is started. With
/// one for each thread the server stays a sixth larger after scenes are removed.
void keep_memory_together();

}  // namespace pelage
