#include "server/scene/follow_guides.h"

#include <fmt/format.h>

#include "base/limits.h"
#include "server/groom/evaluation_cost.h"
#include "server/guides/guide_keys.h"

namespace pelage {

namespace {

/// Thins the keys to as many as one command may have and may cost.
void thin(Interpolate& command, std::size_t most, const Symmetry& symmetry, const Surface& surface) {
  command.keys = thinned(command.keys, most);
  const double visits = evaluation_cost(command, symmetry, surface, 0).visits;
  if (visits <= limits::evaluation_visits) return;
  const double affordable = static_cast<double>(command.keys.size()) * limits::evaluation_visits / visits;
  command.keys = thinned(command.keys, std::max(static_cast<std::size_t>(affordable), std::size_t{1}));
}

void warn(CommandAnswer& answer, std::size_t curves, std::size_t far, std::size_t used) {
  if (answer.results.empty()) return;
  std::vector<std::string>& warnings = answer.results.front().warnings;
  if (far > 0)
    warnings.push_back(fmt::format("{} of {} curves are left out: their roots stand more than {} sizes off the skin",
                                   far, curves, guide_reach));
  if (used < curves - far)
    warnings.push_back(fmt::format("{} of {} curves are used, evenly by their order", used, curves - far));
}

}  // namespace

Result<CommandAnswer> follow_guides(Scene& scene, const GuideUpload& upload, const std::vector<GuideCurve>& curves,
                                    const ExecuteOptions& options) {
  Interpolate command;
  command.strength = upload.strength;
  const SnapshotPtr now = scene.snapshot();
  const Surface& surface = now->model->surface;
  GuideKeys found = keys_of(curves, surface, now->settings->coat);
  command.keys = std::move(found.keys);
  thin(command, static_cast<std::size_t>(upload.keys), now->settings->symmetry, surface);
  command.sigma = upload.sigma.value_or(sigma_between(command.keys.size(), surface.mesh()));
  if (command.keys.empty()) {
    return failure(Code::invalid, "No curve of the file stands on the skin; are its axes and unit those of the model?",
                   "", fmt::format("roots at most {} sizes from the skin", guide_reach));
  }
  const std::size_t used = command.keys.size();
  Result<CommandAnswer> answer = scene.execute({std::move(command)}, options);
  if (answer) warn(*answer, curves.size(), found.far, used);
  return answer;
}

}  // namespace pelage
