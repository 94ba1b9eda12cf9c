// The members of SceneStore, for the files that implement it.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "base/status.h"
#include "server/builtin/builtin_cache.h"
#include "server/history/journal.h"
#include "server/scene/open_scenes.h"
#include "server/scene/scene_store.h"

namespace pelage {

struct SceneStore::Impl {
  std::unique_ptr<Journal> journal;
  std::string worker;
  std::size_t undo_bytes = 0;  // limit for each scene
  std::atomic<std::uint64_t> last_model{0};
  BuiltinCache builtins;
  OpenScenes scenes;

  explicit Impl(std::size_t memory) : scenes(memory, [this](const std::string& id) { return opened(id); }) {}

  Result<std::shared_ptr<const SceneModel>> model_of(const StoredScene& stored);
  /// A scene, and the error that stopped its log from being restored completely; ok if there was none.
  using Restored = std::pair<std::shared_ptr<Scene>, Status>;
  Result<Restored> restored(const std::string& id);
  Result<std::shared_ptr<Scene>> opened(const std::string& id);
  Result<std::shared_ptr<Scene>> add(StoredScene stored, std::shared_ptr<const SceneModel> model, FirstGroom fur);
};

}  // namespace pelage
