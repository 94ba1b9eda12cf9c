// The scene of a job, in a temporary journal of its own.
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
  /// not_found if the file cannot be read, with invalid and a pointer into the job, and as SceneStore does.
  static Result<JobScene> open(const RenderJob& job, const std::string& folder);

  const std::shared_ptr<Scene>& scene() const { return scene_; }
  /// Returns the scene's model, for computing other poses of it.
  Result<MovingModel> moving_model() const { return store_->moving_model(*scene_); }
  std::uint64_t new_model_id() const { return store_->new_model_id(); }

 private:
  JobScene(TemporaryFolder folder, std::unique_ptr<SceneStore> store, std::shared_ptr<Scene> scene)
      : folder_(std::move(folder)), store_(std::move(store)), scene_(std::move(scene)) {}

  TemporaryFolder folder_;  // destroyed last
  std::unique_ptr<SceneStore> store_;
  std::shared_ptr<Scene> scene_;
};

}  // namespace pelage
