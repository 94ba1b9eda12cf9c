// The motion of a job's model before a frame, which makes its fur swing.
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
  /// The poses of the model at frames.
  struct Source {
    /// Returns the same name for frames with the same pose, as in a loop; "" for frames before the first or after the
    /// last one that exists, where the model holds still.
    std::function<Result<std::string>(int frame)> name;
    std::function<Result<RawModel>(int frame)> load;
  };

  /// The model must outlive this object. `strength` is JobMotion::inertia. Takes about 12 bytes for each vertex and
  /// frame of the warm-up.
  PoseHistory(const MovingModel& model, double fps, double strength, Source source);

  /// Returns the accelerations that swing the fur of a frame; `time` is the scene's time at that frame. They are second
  /// differences of the vertices' positions, interpolated linearly between frames in coordinates that rotate with the
  /// skin, and then rotated to the skin at this frame. Loads the frames of the warm-up (server/motion) that are not
  /// known yet. Fails as the source and MovingModel do.
  Result<BodySwing> at(int frame, double time);

  /// Returns how many frames before a frame the oldest acceleration lies that its swing depends on. The swing depends
  /// on the pose of the frame before that one, too, and on that of the frame after its own.
  static int frames_before(double fps);

 private:
  struct Pose {
    std::vector<glm::vec3> positions;
    std::vector<glm::mat3> rotations;  // rotations of vertices, relative to the model at rest
  };
  using Accelerations = std::shared_ptr<const std::vector<glm::vec3>>;  // rotated to the model at rest

  Result<std::shared_ptr<const Pose>> pose(int frame);  // null if the model holds still
  /// Counts how often each name occurs in the warm-up of a frame.
  Result<std::map<std::string, int>> names_before(int frame) const;
  Result<Accelerations> acceleration(int frame);

  const MovingModel& model_;
  double fps_, strength_;
  Source source_;
  std::map<std::string, std::shared_ptr<const Pose>> poses_;  // by name
  std::map<int, Accelerations> accelerations_;
};

}  // namespace pelage
