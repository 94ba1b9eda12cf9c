// Frames that wait: their expected cost, and the queue that takes the shortest first.
//
// What frames are drawn on, and what a view's estimates are estimated from.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "protocol/commands/frame.h"
#include "renderer/frame/renderer.h"
#include "renderer/gl/context/context.h"
#include "renderer/quality/view_features.h"
#include "server/scene/scene.h"

namespace pelage {

/// Threads that the CPU draws on; `asked` as of select_context: 0 for all cores.
int drawing_threads(int asked);

/// By the context, or on the CPU where that is null. Fails as Renderer::create does.
Result<std::unique_ptr<Renderer>> make_renderer(const Context* context, int threads);
/// What draws: "EGL device, NVIDIA ..., OpenGL 4.5" or "AVX2 on the CPU".
std::string drawn_by(const Context* context);

/// Milliseconds that a frame of shells may take, above 0: a guess before its view is known, to order requests by.
double expected_cost(const FrameRequest& request);

/// Views of the scene.
FurredSkin furred_skin(const SceneView& scene);

// The order in which requests are served: what is short goes first, and nothing waits for ever.

/// A job is due `idle_timeout` times its expected cost after it came, and what is due first goes first: the short pass
/// the long, but none that came so much later. Of those that are due together the one that came first. The clock is the
/// caller's: milliseconds from any moment.
template <class Job>
class ShortestFirst {
 public:
  static constexpr double idle_timeout = 8;
  /// What is let in between the pieces of a running job costs at most this share of it.
  static constexpr double let_in_share = 0.5;

  bool empty() const { return waiting_.empty(); }
  std::size_t size() const { return waiting_.size(); }

  /// `cost` in milliseconds, as expected.
  void add(Job job, double cost, double now) {
    waiting_.push_back({std::move(job), cost, now + idle_timeout * cost, came_++});
  }

  struct Taken {
    Job job;
    double cost = 0;  // as it was expected
  };
  /// None where none waits.
  std::optional<Taken> take() {
    return take_of([](const Waiting&) { return true; });
  }

  /// Marks those that wait now.
  std::uint64_t moment() const { return came_; }
  /// The first of those that came before the moment, cost little beside a running job and are let in by `may`. So a
  /// running job that lets in those that wait when it pauses goes on however many come.
  std::optional<Taken> take_beside(double running_cost, std::uint64_t moment,
                                   const std::function<bool(const Job&)>& may) {
    return take_of([&](const Waiting& one) {
      return one.came < moment && one.cost <= let_in_share * running_cost && may(one.job);
    });
  }

  /// All that wait, in the order that they came in: use(job, cost).
  template <class Use>
  void for_each(const Use& use) const {
    for (const Waiting& one : waiting_) use(one.job, one.cost);
  }

  /// The first job, in the order that they came in, that is `wanted`; null where none is.
  Job* find(const std::function<bool(const Job&)>& wanted) {
    const auto found =
        std::find_if(waiting_.begin(), waiting_.end(), [&](const Waiting& one) { return wanted(one.job); });
    return found == waiting_.end() ? nullptr : &found->job;
  }

 private:
  struct Waiting {
    Job job;
    double cost, due;
    std::uint64_t came;
  };

  template <class Fits>
  std::optional<Taken> take_of(const Fits& fits) {
    auto first = waiting_.end();
    for (auto one = waiting_.begin(); one != waiting_.end(); ++one) {
      if (fits(*one) && (first == waiting_.end() || one->due < first->due)) first = one;
    }
    if (first == waiting_.end()) return {};
    std::optional<Taken> taken = Taken{std::move(first->job), first->cost};
    waiting_.erase(first);
    return taken;
  }

  std::vector<Waiting> waiting_;  // in the order that they came in
  std::uint64_t came_ = 0;
};

}  // namespace pelage
