#include "server/batch/pose_history.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "server/motion/sway.h"
#include "server/surface/turns.h"

namespace pelage {

namespace {

/// Forgets what lies before `first`.
template <class T>
void forget_before(std::map<int, T>& known, int first) {
  known.erase(known.begin(), known.lower_bound(first));
}

}  // namespace

PoseHistory::PoseHistory(const MovingModel& model, double fps, double strength, Load load)
    : model_(model), fps_(fps), strength_(strength), load_(std::move(load)) {}

int PoseHistory::frames_before(double fps) { return static_cast<int>(std::ceil(warm_up_seconds * fps)) + 1; }

Result<const PoseHistory::Pose*> PoseHistory::pose(int frame) {
  const auto known = poses_.find(frame);
  if (known != poses_.end()) return known->second.get();
  Result<std::optional<RawModel>> raw = load_(frame);
  if (!raw) return raw.status();
  std::shared_ptr<const Pose>& kept = poses_[frame];
  if (!*raw) return kept.get();
  Result<Mesh> mesh = model_.mesh(**raw);
  if (!mesh) return mesh.status();
  Pose made{std::move(mesh->positions), {}};
  for (const glm::dmat3& turn : surface_turns(model_.rest(), made.positions)) made.turns.emplace_back(turn);
  kept = std::make_shared<const Pose>(std::move(made));
  return kept.get();
}

Result<PoseHistory::Accelerations> PoseHistory::acceleration(int frame) {
  const auto known = accelerations_.find(frame);
  if (known != accelerations_.end()) return known->second;
  const Pose* around[3];
  for (int k = 0; k < 3; ++k) {
    const Result<const Pose*> at = pose(frame - 1 + k);
    if (!at) return at.status();
    around[k] = *at;
  }
  if (!around[0] || !around[1] || !around[2]) return accelerations_[frame] = nullptr;
  std::vector<glm::vec3> found;
  for (std::size_t v = 0; v < around[1]->positions.size(); ++v) {
    const glm::dvec3 before(around[0]->positions[v]), now(around[1]->positions[v]), after(around[2]->positions[v]);
    const glm::dvec3 acceleration = (before - 2.0 * now + after) * (fps_ * fps_ * strength_);
    found.emplace_back(glm::transpose(glm::dmat3(around[1]->turns[v])) * acceleration);
  }
  return accelerations_[frame] = std::make_shared<const std::vector<glm::vec3>>(std::move(found));
}

Result<BodySwing> PoseHistory::at(int frame, double time) {
  const int first = frame - frames_before(fps_);
  forget_before(poses_, first - 1), forget_before(accelerations_, first);
  std::vector<Accelerations> history;
  for (int k = first; k <= frame; ++k) {
    Result<Accelerations> found = acceleration(k);
    if (!found) return found.status();
    history.push_back(std::move(*found));
  }
  if (const Result<const Pose*> now = pose(frame); !now) return now.status();
  const std::shared_ptr<const Pose> now = poses_.at(frame);
  const double fps = fps_;
  const auto at_place = [history, now, time, fps](std::uint32_t vertex, double when) {
    const double last = static_cast<double>(history.size() - 1);
    const double place = std::clamp(last + (when - time) * fps, 0.0, last);
    const auto low = static_cast<std::size_t>(place), high = std::min(low + 1, history.size() - 1);
    const auto known = [&](std::size_t k) { return history[k] ? glm::dvec3((*history[k])[vertex]) : glm::dvec3(0); };
    const glm::dvec3 felt = glm::mix(known(low), known(high), place - static_cast<double>(low));
    return now ? glm::dmat3(now->turns[vertex]) * felt : felt;
  };
  return BodySwing{at_place, std::clamp(1 / fps_, 1e-3, 1.0)};
}

}  // namespace pelage
