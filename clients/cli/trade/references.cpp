#include "clients/cli/trade/references.h"

#include <fmt/format.h>

#include <algorithm>

namespace pelage::trade {

namespace {

/// Of the default knobs, which have the estimate.
const std::string plain_name = "R1";

/// More samples of a pixel make another picture: finer strands are told apart before they are averaged.
double truth_scale(const Knobs& knobs) { return std::max(1.0, knobs.scale); }

std::string name_of_shells(const Knobs& knobs) {
  const std::string size = knobs.scale > 1 ? fmt::format("{} at {:g} times the size", plain_name, knobs.scale) : plain_name;
  if (knobs.shadow_maps) return fmt::format("{} with maps of {}", size, knobs.shadow_resolution);
  return knobs.self_shadow ? size : size + " without self-shadow";
}

/// The truth for these knobs: with their shadows, and their scale where it is above 1.
Knobs converged(int shells, const Knobs& wanted) {
  Knobs knobs;
  knobs.shells = shells;
  knobs.shell_policy = ShellPolicy::uniform;
  knobs.scale = truth_scale(wanted), knobs.fins = false, knobs.guard_hairs = 0;
  knobs.order = FragmentOrder::sorted;
  knobs.self_shadow = wanted.self_shadow, knobs.shadow_maps = wanted.shadow_maps;
  knobs.shadow_resolution = wanted.shadow_resolution;
  return knobs;
}

}  // namespace

Result<Truth> References::draw(const std::string& name, const Knobs& knobs) {
  auto shot = shoot(session_, place_, knobs);
  if (!shot) return shot.status();
  if (shot->non_finite > 0) return failure(Code::internal, name + " has pixels that are not finite: it is no truth.");
  return Truth{name, std::move(*shot), knobs.method == Method::strands ? passes_ : shells_};
}

Result<const Truth*> References::keep(Truth truth) {
  const std::string name = truth.name;
  return &(drawn_[name] = std::move(truth));
}

Result<const Truth*> References::shells(const Knobs& wanted) {
  const std::string name = name_of_shells(wanted);
  if (const auto found = drawn_.find(name); found != drawn_.end()) return &found->second;
  auto truth = draw(name, converged(shells_, wanted));
  if (!truth) return truth.status();
  if (name != plain_name) {
    const auto plain = shells({});
    if (!plain) return plain;
    truth->floor = (*plain)->floor;
    return keep(std::move(*truth));
  }
  const auto half = shoot(session_, place_, converged(shells_ / 2, wanted));
  if (!half) return half.status();
  const auto error = error_of(truth->shot.picture, half->picture);
  if (!error) return error.status();
  if (error->figures) truth->floor = error->figures->flip.mean;
  return keep(std::move(*truth));
}

Result<const Truth*> References::strands() {
  if (const auto found = drawn_.find("R2"); found != drawn_.end()) return &found->second;
  Knobs knobs = knobs_of(Tier::reference);
  knobs.trace.passes = passes_;
  knobs.trace.scattering = StrandScattering::look;
  auto truth = draw("R2", knobs);
  if (!truth) return truth.status();
  return keep(std::move(*truth));
}

}  // namespace pelage::trade
