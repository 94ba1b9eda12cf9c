#include "server/scene/follow_guides.h"

#include <fmt/format.h>

#include "base/limits.h"
#include "server/fields/coats.h"
#include "server/groom/evaluation_cost.h"
#include "server/guides/guide_keys.h"
#include "server/scene/model.h"
#include "server/surface/prepare.h"

namespace pelage {

namespace {

/// Thins the keys to at most `max_keys`, and to what one command may cost.
void thin(Interpolate& command, std::size_t max_keys, const Symmetry& symmetry, const Surface& surface) {
  command.keys = thinned(command.keys, max_keys);
  const double visits = evaluation_cost(command, symmetry, surface, 0).visits;
  if (visits <= limits::evaluation_visits) return;
  const double affordable = static_cast<double>(command.keys.size()) * limits::evaluation_visits / visits;
  command.keys = thinned(command.keys, std::max(static_cast<std::size_t>(affordable), std::size_t{1}));
}

void warn(CommandAnswer& answer, std::size_t single, std::size_t curves, std::size_t far, std::size_t used) {
  if (answer.results.empty()) return;
  std::vector<std::string>& warnings = answer.results.front().warnings;
  if (single > 0)
    warnings.push_back(
        fmt::format("{} of {} curves are left out: they have fewer than two points", single, curves + single));
  if (far > 0)
    warnings.push_back(fmt::format("{} of {} curves are left out: their roots stand more than {} sizes off the skin",
                                   far, curves, guide_reach));
  if (used < curves - far)
    warnings.push_back(fmt::format("{} of {} curves are used, evenly by their order", used, curves - far));
}

bool is_z(Axis axis) { return axis == Axis::plus_z || axis == Axis::minus_z; }
bool is_y(Axis axis) { return axis == Axis::plus_y || axis == Axis::minus_y; }

/// Returns the rotation between axes with Y up and axes with Z up; the identity if both have the same axis up or one
/// has X.
glm::dmat3 stood_up(Axis from, Axis to) {
  const glm::dmat3 z_to_y(glm::dvec3(1, 0, 0), glm::dvec3(0, 0, -1), glm::dvec3(0, 1, 0));
  if (is_z(from) && is_y(to)) return z_to_y;
  return is_y(from) && is_z(to) ? glm::transpose(z_to_y) : glm::dmat3(1);
}

/// Returns the curves in the scene's model coordinates.
std::vector<GuideCurve> in_scene(const GuideFile& file, const GuideUpload& upload, const SceneModel& model) {
  const ModelReport& report = model.surface.mesh().report;
  const bool as_source = upload.format != GuideFormat::json;
  const bool source = upload.frame.value_or(as_source ? AssetFrame::source : AssetFrame::pelage) == AssetFrame::source;
  const Axis up = source ? report.up : Axis::plus_y;
  const std::optional<double> metres = upload.metres_per_unit ? upload.metres_per_unit : metres_of(model.name);
  const double scale = file.metres && metres ? *file.metres / *metres : 1;
  const glm::dmat3 rotation =
      scale * (source ? axes_rotation(report.up, report.front) : glm::dmat3(1)) * stood_up(file.up.value_or(up), up);
  std::vector<GuideCurve> curves = file.curves;
  for (GuideCurve& curve : curves)
    for (glm::dvec3& point : curve) point = rotation * point;
  return curves;
}

}  // namespace

Result<CommandAnswer> follow_guides(Scene& scene, const GuideUpload& upload, const GuideFile& file,
                                    const ExecuteOptions& options) {
  Interpolate command;
  command.strength = upload.strength;
  if (!upload.coat.empty()) command.coats = {upload.coat};
  const SnapshotPtr now = scene.snapshot();
  const NamedCoat* coat = find_coat(now->settings->coats, upload.coat);
  if (!coat) return failure(Code::invalid, "The scene has no coat of this name.", "/coat");
  const Surface& surface = now->model->surface;
  const std::vector<GuideCurve> curves = in_scene(file, upload, *now->model);
  GuideKeys found = keys_of(curves, surface, coat->coat);
  command.keys = std::move(found.keys);
  thin(command, static_cast<std::size_t>(upload.keys), now->settings->symmetry, surface);
  command.sigma = upload.sigma.value_or(sigma_between(command.keys.size(), surface.mesh()));
  if (command.keys.empty()) {
    return failure(Code::invalid, "No curve of the file stands on the skin; are its axes and unit those of the model?",
                   "", fmt::format("roots at most {} sizes from the skin", guide_reach));
  }
  const std::size_t used = command.keys.size();
  Result<CommandAnswer> answer = scene.execute({std::move(command)}, options);
  if (answer) warn(*answer, file.single, curves.size(), found.far, used);
  return answer;
}

}  // namespace pelage
