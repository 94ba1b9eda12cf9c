// The scene of a job, in a journal of its own that goes with the process.
#pragma once

#include <memory>
#include <string>

#include "base/status.h"
#include "protocol/commands/job.h"
#include "server/export/temporary_folder.h"
#include "server/scene/scene_store.h"

namespace pelage {

class JobScene {
 public:
  /// Opens the job's file (relative to `folder`) or makes its built-in model, and runs its commands. Fails with
  /// not_found where there is no such file, invalid with the pointer into the job, and as SceneStore does.
  static Result<JobScene> open(const RenderJob& job, const std::string& folder);

  const std::shared_ptr<Scene>& scene() const { return scene_; }
  /// Its model, ready to stand elsewhere.
  Result<MovingModel> moving_model() const { return store_->moving_model(*scene_); }
  std::uint64_t new_model_id() const { return store_->new_model_id(); }

 private:
  JobScene(TemporaryFolder folder, std::unique_ptr<SceneStore> store, std::shared_ptr<Scene> scene)
      : folder_(std::move(folder)), store_(std::move(store)), scene_(std::move(scene)) {}

  TemporaryFolder folder_;  // goes last
  std::unique_ptr<SceneStore> store_;
  std::shared_ptr<Scene> scene_;
};

}  // namespace pelage
