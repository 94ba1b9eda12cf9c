// How a job's model moved before a frame: what makes its fur swing.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "base/status.h"
#include "server/scene/moving_model.h"

namespace pelage {

class PoseHistory {
 public:
  /// Where the model stands at each frame.
  struct Source {
    /// Returns the same name for frames with the same pose, as in a loop; "" before the first and after the last frame
    /// that there is, where the model holds still.
    std::function<Result<std::string>(int frame)> name;
    std::function<Result<RawModel>(int frame)> load;
  };

  /// The model outlives it. `strength` is JobMotion::inertia. Takes about 12 bytes for each vertex and frame of the
  /// warm-up.
  PoseHistory(const MovingModel& model, double fps, double strength, Source source);

  /// Returns the accelerations that swing the fur of a frame; `time` is the scene's there. They are second differences
  /// of the vertices' positions at frames, linear in between, in the coordinates of the skin at each frame, and rotated
  /// to those at this one. Loads the frames of the warm-up (server/motion) that are not known yet. Fails as the source
  /// and MovingModel do.
  Result<BodySwing> at(int frame, double time);

  /// Returns how many frames before a frame its swing depends on; it depends on one after it, too.
  static int frames_before(double fps);

 private:
  struct Pose {
    std::vector<glm::vec3> positions;
    std::vector<glm::mat3> turns;  // since the model at rest
  };
  using Accelerations = std::shared_ptr<const std::vector<glm::vec3>>;  // in coordinates of the model at rest

  Result<std::shared_ptr<const Pose>> pose(int frame);  // null where the model holds still
  /// How often each name comes in the warm-up of a frame.
  Result<std::map<std::string, int>> names_before(int frame) const;
  Result<Accelerations> acceleration(int frame);

  const MovingModel& model_;
  double fps_, strength_;
  Source source_;
  std::map<std::string, std::shared_ptr<const Pose>> poses_;  // by name
  std::map<int, Accelerations> accelerations_;
};

}  // namespace pelage
