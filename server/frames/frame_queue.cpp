#include "server/frames/frame_queue.h"

#include <algorithm>

#include "base/parallel.h"
#include "renderer/raster/kernels.h"

namespace pelage {

int drawing_threads(int asked) { return asked > 0 ? asked : core_count(); }

Result<std::unique_ptr<Renderer>> make_renderer(const Context* context, int threads, CoatSource coats) {
  const RendererOptions options{.threads = threads, .coats = std::move(coats)};
  if (!context) return std::make_unique<Renderer>(options);
  return Renderer::create(context->gl(), options);
}

std::string drawn_by(const Context* context, bool strands_by_gl) {
  const std::string cpu = std::string(instruction_set()) + " on the CPU";
  if (!context) return cpu;
  return strands_by_gl ? context->description() : cpu + ", shells by " + context->description();
}

void TurnCounts::join(JobOwner owner) {
  const auto fewest = std::min_element(waiting_.begin(), waiting_.end(),
                                       [](const auto& a, const auto& b) { return a.second.turns < b.second.turns; });
  const std::uint64_t turns = fewest == waiting_.end() ? 0 : fewest->second.turns;
  ++waiting_.try_emplace(owner, Waits{turns, 0}).first->second.jobs;
}

void TurnCounts::take(JobOwner owner) {
  const auto found = waiting_.find(owner);
  ++found->second.turns;
  if (--found->second.jobs == 0) waiting_.erase(found);
}

}  // namespace pelage
