#include "server/batch/pose_history.h"

#include <algorithm>
#include <cmath>

#include "server/motion/sway.h"
#include "server/surface/turns.h"

namespace pelage {

PoseHistory::PoseHistory(const MovingModel& model, double fps, double strength, Source source)
    : model_(model), fps_(fps), strength_(strength), source_(std::move(source)) {}

int PoseHistory::frames_before(double fps) { return static_cast<int>(std::ceil(warm_up_seconds * fps)) + 1; }

Result<std::shared_ptr<const PoseHistory::Pose>> PoseHistory::pose(int frame) {
  const Result<std::string> name = source_.name(frame);
  if (!name) return name.status();
  if (name->empty()) return std::shared_ptr<const Pose>();
  const auto known = poses_.find(*name);
  if (known != poses_.end()) return known->second;
  const Result<RawModel> raw = source_.load(frame);
  if (!raw) return raw.status();
  Result<Mesh> mesh = model_.mesh(*raw);
  if (!mesh) return mesh.status();
  auto made = std::make_shared<Pose>(Pose{std::move(mesh->positions), {}});
  for (const glm::dmat3& rotation : surface_rotations(model_.rest(), made->positions))
    made->rotations.emplace_back(rotation);
  return poses_[*name] = std::move(made);
}

Result<std::map<std::string, int>> PoseHistory::names_before(int frame) const {
  std::map<std::string, int> names;
  for (int k = frame - frames_before(fps_) - 1; k <= frame + 1; ++k) {
    const Result<std::string> name = source_.name(k);
    if (!name) return name.status();
    ++names[*name];
  }
  return names;
}

Result<PoseHistory::Accelerations> PoseHistory::acceleration(int frame) {
  const auto known = accelerations_.find(frame);
  if (known != accelerations_.end()) return known->second;
  std::shared_ptr<const Pose> around[3];
  for (int k = 0; k < 3; ++k) {
    Result<std::shared_ptr<const Pose>> at = pose(frame - 1 + k);
    if (!at) return at.status();
    around[k] = std::move(*at);
  }
  if (!around[0] || !around[1] || !around[2]) return accelerations_[frame] = nullptr;
  std::vector<glm::vec3> found;
  for (std::size_t v = 0; v < around[1]->positions.size(); ++v) {
    const glm::dvec3 before(around[0]->positions[v]), now(around[1]->positions[v]), after(around[2]->positions[v]);
    const glm::dvec3 acceleration = (before - 2.0 * now + after) * (fps_ * fps_ * strength_);
    found.emplace_back(glm::transpose(glm::dmat3(around[1]->rotations[v])) * acceleration);
  }
  return accelerations_[frame] = std::make_shared<const std::vector<glm::vec3>>(std::move(found));
}

Result<BodySwing> PoseHistory::at(int frame, double time) {
  const int first = frame - frames_before(fps_);
  accelerations_.erase(accelerations_.begin(), accelerations_.lower_bound(first));
  const Result<std::map<std::string, int>> names = names_before(frame);
  if (!names) return names.status();
  std::vector<Accelerations> history;
  for (int k = first; k <= frame; ++k) {
    Result<Accelerations> found = acceleration(k);
    if (!found) return found.status();
    history.push_back(std::move(*found));
    // Positions and rotations are large: only poses that occur again stay in memory.
    const Result<std::string> passed = source_.name(k - 1);
    if (passed && k < frame && (!names->contains(*passed) || names->at(*passed) == 1)) poses_.erase(*passed);
  }
  const Result<std::shared_ptr<const Pose>> current = pose(frame);
  if (!current) return current.status();
  const auto acceleration_at = [history, now = *current, time, fps = fps_](std::uint32_t vertex, double when) {
    const double last = static_cast<double>(history.size() - 1);
    const double index = std::clamp(last + (when - time) * fps, 0.0, last);
    const auto low = static_cast<std::size_t>(index), high = std::min(low + 1, history.size() - 1);
    const auto known = [&](std::size_t k) { return history[k] ? glm::dvec3((*history[k])[vertex]) : glm::dvec3(0); };
    const glm::dvec3 interpolated = glm::mix(known(low), known(high), index - static_cast<double>(low));
    return now ? glm::dmat3(now->rotations[vertex]) * interpolated : interpolated;
  };
  return BodySwing{acceleration_at, std::clamp(1 / fps_, 1e-3, 1.0)};
}

}  // namespace pelage
