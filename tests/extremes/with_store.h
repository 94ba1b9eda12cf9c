// A scene store in a temporary folder.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>

#include "server/import/import.h"
#include "server/scene/scene_store.h"
#include "tests/gl/with_renderer.h"

namespace pelage::testing {

/// A scene store that starts empty and is deleted with its owner.
class FreshStore {
 public:
  explicit FreshStore(std::string name) : folder_(std::filesystem::path(::testing::TempDir()) / std::move(name)) {
    std::filesystem::remove_all(folder_);
    auto store = SceneStore::open(folder_.string(), program_folder() + "/pelage-import");
    EXPECT_TRUE(store.ok()) << store.status().message;
    if (store) store_ = std::move(store).value();
  }
  ~FreshStore() {
    store_.reset();
    std::filesystem::remove_all(folder_);
  }
  SceneStore* operator->() { return store_.get(); }
  SceneStore& operator*() { return *store_; }
  FreshStore(const FreshStore&) = delete;
  FreshStore& operator=(const FreshStore&) = delete;

 private:
  std::filesystem::path folder_;
  std::unique_ptr<SceneStore> store_;
};

}  // namespace pelage::testing
