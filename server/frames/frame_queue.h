// The queue of waiting frames, in which short frames go first and scenes take turns; and the creation of the renderer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context/context.h"
#include "renderer/quality/view_features.h"
#include "server/scene/scene.h"

namespace pelage {

/// Returns the number of threads that draw on the CPU. `asked` is as in select_context: 0 for all cores.
int drawing_threads(int asked);

/// Makes a renderer, which uses GL if there is a context. Fails as Renderer::create does.
Result<std::unique_ptr<Renderer>> make_renderer(const Context* context, int threads, CoatSource coats = bake_here);
/// Returns a description of what draws: "AVX2 on the CPU"; with a GPU "EGL device 0, NVIDIA ..., OpenGL 4.5"; with a
/// software GL, which draws only shells, "AVX2 on the CPU, shells by OSMesa, ...".
std::string drawn_by(const Context* context, bool strands_by_gl);

// The order of service: short requests go first, but none waits for ever.

/// The owner of a job, for fairness. Viewers of one scene share its turns.
struct JobOwner {
  std::uint64_t scene = 0, view = 0;
  bool operator<(const JobOwner& other) const { return std::pair(scene, view) < std::pair(other.scene, other.view); }
};

/// Counts the turns of each waiting owner. A new owner starts with as many turns as the one with the fewest.
class TurnCounts {
 public:
  void join(JobOwner owner);
  void take(JobOwner owner);
  std::uint64_t of(JobOwner owner) const { return waiting_.at(owner).turns; }

 private:
  struct Waits {
    std::uint64_t turns = 0, jobs = 0;
  };
  std::map<JobOwner, Waits> waiting_;
};

/// A queue in which scenes take turns, and within a scene its views: a scene with a thousand waiting frames delays no
/// other scene. Within an owner, each job has a due time, `due_per_cost` times its expected cost after its arrival,
/// and the earliest due time goes first: short jobs overtake long ones unless they arrive much later. Of equal due
/// times the first arrival goes first. The caller supplies the clock, in milliseconds from any origin.
template <class Job>
class ShortestFirst {
 public:
  static constexpr double due_per_cost = 8;
  /// The maximum cost of a job that may be drawn in the pauses of a running job, relative to the running job's cost.
  static constexpr double max_interleaved_share = 0.5;

  bool empty() const { return waiting_.empty(); }
  std::size_t size() const { return waiting_.size(); }

  /// Adds a job. `cost` is the expected cost in milliseconds.
  void add(Job job, double cost, double now, JobOwner owner = {}) {
    scene_turns_.join({owner.scene, 0}), view_turns_.join(owner);
    waiting_.push_back({std::move(job), cost, now + due_per_cost * cost, next_arrival_++, owner});
  }

  struct Taken {
    Job job;
    double cost, due;  // expected cost and due time, milliseconds
    std::uint64_t arrival;
    JobOwner owner;
  };
  /// Takes the first job that is `ready`; nothing if there is none.
  std::optional<Taken> take(const std::function<bool(const Job&)>& ready = [](const Job&) { return true; }) {
    return take_of([&](const Taken& one) { return ready(one.job); });
  }

  /// Puts a taken job back at its old position in the queue. It has used its turn.
  void put_back(Taken taken) {
    scene_turns_.join({taken.owner.scene, 0}), view_turns_.join(taken.owner);
    const auto later =
        std::find_if(waiting_.begin(), waiting_.end(), [&](const Taken& one) { return one.arrival > taken.arrival; });
    waiting_.insert(later, std::move(taken));
  }

  bool any(const std::function<bool(const Job&)>& wanted) const {
    return std::any_of(waiting_.begin(), waiting_.end(), [&](const Taken& one) { return wanted(one.job); });
  }

  /// Returns a mark for take_interleaved, later than the arrival of all jobs that wait now.
  std::uint64_t moment() const { return next_arrival_; }
  /// Takes the first job that arrived before the mark `moment`, costs at most max_interleaved_share of the running job,
  /// and is accepted by `may`. By the mark a running job admits only jobs that wait when it pauses, so it continues
  /// however many arrive.
  std::optional<Taken> take_interleaved(double running_cost, std::uint64_t moment,
                                        const std::function<bool(const Job&)>& may) {
    return take_of([&](const Taken& one) {
      return one.arrival < moment && one.cost <= max_interleaved_share * running_cost && may(one.job);
    });
  }

  /// Visits all waiting jobs, in order of arrival.
  template <class Use>
  void for_each(const Use& use) const {
    for (const Taken& one : waiting_) use(one.job);
  }

  /// Returns the first job, in order of arrival, that is `wanted`; null if there is none.
  Job* find(const std::function<bool(const Job&)>& wanted) {
    const auto found =
        std::find_if(waiting_.begin(), waiting_.end(), [&](const Taken& one) { return wanted(one.job); });
    return found == waiting_.end() ? nullptr : &found->job;
  }

 private:
  template <class Fits>
  std::optional<Taken> take_of(const Fits& fits) {
    const auto rank = [&](const Taken& one) {
      return std::tuple(scene_turns_.of({one.owner.scene, 0}), view_turns_.of(one.owner), one.due);
    };
    auto first = waiting_.end();
    for (auto one = waiting_.begin(); one != waiting_.end(); ++one) {
      if (fits(*one) && (first == waiting_.end() || rank(*one) < rank(*first))) first = one;
    }
    if (first == waiting_.end()) return {};
    std::optional<Taken> taken = std::move(*first);
    waiting_.erase(first);
    scene_turns_.take({taken->owner.scene, 0}), view_turns_.take(taken->owner);
    return taken;
  }

  std::vector<Taken> waiting_;  // in order of arrival
  TurnCounts scene_turns_, view_turns_;
  std::uint64_t next_arrival_ = 0;
};

}  // namespace pelage
