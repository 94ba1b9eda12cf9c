// Plans the commands of a batch: pixels become positions on the surface, the names of commands are checked, and each
// command gets the fields and pictures that it needs.
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "server/fields/coats.h"
#include "server/fields/edit_layers.h"
#include "server/groom/evaluate.h"
#include "server/scene/batch.h"
#include "server/scene/map_pictures.h"
#include "server/scene/scene.h"

namespace pelage {

namespace {

/// Returns the step of a retarget: its source, and the command with the source's revision filled in.
Result<Step> with_source(Retarget command, const std::vector<GroomSource>& sources) {
  const auto source = std::find_if(sources.begin(), sources.end(), [&](const GroomSource& one) {
    return one.scene == command.scene && one.asked == command.revision;
  });
  if (source == sources.end())
    return failure(Code::invalid, "the server has no such scene to take fields from", "/scene");
  command.revision = source->revision;
  return Step{std::move(command), source->fields, {source->model, &source->model->surface}};
}

}  // namespace

Result<Scene::Plan> Scene::plan(const std::vector<Command>& commands, const ExecuteOptions& options) const {
  Plan plan;
  BatchPictures pictures(journal_);
  // A later part of a stroke sees the fur as it was before the stroke, so that parts give the same result as the whole
  // stroke at once.
  std::optional<FieldSet> before_stroke;
  if (commands.size() == 1 && live_.joins(commands.front())) {
    const Result<FieldDelta> so_far = history_.last_step();
    if (!so_far) return so_far.status();
    before_stroke.emplace(*present_->fields).apply(*so_far);
  }
  const FieldSet& seen = before_stroke ? *before_stroke : *present_->fields;
  double visits = 0;
  const Past past{
      *present_->settings, seen, [this](Revision revision) { return fields_at(revision); }, options, pictures, visits};
  for (std::size_t k = 0; k < commands.size(); ++k) {
    Status parts = commands.size() > 1 ? check_complete_stroke(commands[k]) : Status{};
    Result<Step> step = parts.ok() ? prepare(commands[k], plan.to_log, past) : parts;
    if (!step) return in_batch(step.status(), k, commands.size());
    plan.to_log.push_back(step->command);
    plan.merged.push_back(std::move(*step));
  }
  if (commands.size() != 1) return plan;
  Result<LiveStroke::Plan> live = live_.plan(plan.to_log.front());
  if (!live) return live.status();
  if (live->joins) {  // the whole stroke may exceed a limit although no single part does
    if (Result<Command> checked = resolve(live->merged, present_->model->surface); !checked) return checked.status();
  }
  plan.merged.front().command = std::move(live->merged);
  plan.to_log.front() = std::move(live->to_log);
  plan.joins = live->joins;
  return plan;
}

/// Returns a command ready for evaluation: resolved, and with the fields and pictures that it names.
Result<Step> Scene::prepare(const Command& command, const std::vector<Command>& before, const Past& past) const {
  const VisibleFur fur{past.fields, past.settings.coats, past.visits, past.options.cancel};
  Result<Command> resolved = resolve(command, present_->model->surface, &fur);
  if (!resolved) return resolved.status();
  if (Status missing = check_names(*resolved, before, past.settings); !missing.ok()) return missing;
  const auto* retarget = std::get_if<Retarget>(&*resolved);
  Result<Step> step =
      retarget ? with_source(*retarget, past.options.sources) : with_baseline(std::move(*resolved), past);
  if (!step) return step;
  auto pictures = past.pictures.find(step->command, present_->model->surface.mesh().positions.size());
  if (!pictures) return pictures.status();
  step->pictures = std::move(*pictures);
  return step;
}

/// Checks that everything a command names exists in the scene or is made by earlier commands of its batch.
Status Scene::check_names(const Command& command, const std::vector<Command>& before, SceneSettings settings) const {
  for (const Command& earlier : before) settings = with_setting(settings, earlier).value_or(settings);
  const auto missing = [](const auto& list, const std::string& name) {
    return !name.empty() &&
           std::none_of(list.begin(), list.end(), [&](const auto& named) { return named.name == name; });
  };
  if (const auto* blow = std::get_if<Blow>(&command); blow && missing(settings.blowers, blow->blower))
    return failure(Code::invalid, "the scene has no blower of this name", "/blower");
  if (const auto* attract = std::get_if<Attract>(&command); attract && missing(settings.attractors, attract->attractor))
    return failure(Code::invalid, "the scene has no attractor of this name", "/attractor");
  if (const auto* layer = std::get_if<ChangeEditLayer>(&command)) {
    if (layer->coat && !layer->coat->empty() && !find_coat(settings.coats, *layer->coat))
      return failure(Code::invalid, "the scene has no coat of this name", "/coat");
    return check(*layer, settings.layers);
  }
  if (const auto* coats = std::get_if<SetCoats>(&command)) return check(*coats, settings.coats);
  if (const auto* coat = std::get_if<SetCoat>(&command)) return check(*coat, settings.coats);
  if (Status bad = check_groomed(edit_layer_of(command), settings.layers); !bad.ok()) return bad;
  if (Status bad = check_groomed_coats(coats_of(command), edit_layer_of(command), settings.coats, settings.layers);
      !bad.ok())
    return bad;
  const auto* base = std::get_if<SetSkinTexture>(&command);
  if (base == nullptr || base->picture.empty()) return {};
  return check_skin_texture(base->picture, journal_);
}

/// Makes the step of a command, with the fields that an erase restores. Also checks the revision that a checkpoint
/// names.
Result<Step> Scene::with_baseline(Command command, const Past& past) const {
  Step step{std::move(command), nullptr};
  const auto* erase = std::get_if<Erase>(&step.command);
  const auto* checkpoint = std::get_if<Checkpoint>(&step.command);
  if (erase == nullptr && (checkpoint == nullptr || !checkpoint->revision)) return step;
  if (checkpoint != nullptr) {
    const Status there = check_revision(*checkpoint->revision);
    return there.ok() ? Result<Step>(std::move(step)) : there;
  }
  Revision revision = erase->revision.value_or(history_.first_revision());
  if (!erase->checkpoint.empty()) {
    const std::vector<NamedRevision>& known = past.settings.checkpoints;
    const auto named = std::find_if(known.begin(), known.end(),
                                    [&](const NamedRevision& other) { return other.name == erase->checkpoint; });
    if (named == known.end()) return failure(Code::invalid, "the scene has no checkpoint of this name", "/checkpoint");
    revision = named->revision;
  }
  Result<FieldSet> baseline = past.fields_at(revision);
  if (!baseline) return baseline.status();
  step.baseline = std::make_shared<const FieldSet>(std::move(*baseline));
  return step;
}

}  // namespace pelage
