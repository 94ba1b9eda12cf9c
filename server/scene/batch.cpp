#include "server/scene/batch.h"

#include <algorithm>
#include <optional>
#include <string>

#include "base/stopwatch.h"
#include "protocol/json/encode.h"
#include "server/fields/coats.h"
#include "server/fields/edit_layers.h"
#include "server/groom/evaluate.h"
#include "server/groom/evaluation_cost.h"
#include "server/groom/standing_fur.h"
#include "server/groom/together.h"

namespace pelage {

namespace {

std::string text_of(const SceneSettings& settings) { return encode(commands_of(settings)); }

/// Executes a command that changes settings of the scene. Returns whether a setting changed.
bool set(const Command& command, SceneSettings& settings, Revision next) {
  const std::optional<SceneSettings> after = with_setting(settings, command, next);
  if (!after || text_of(*after) == text_of(settings)) return false;
  settings = *after;
  return true;
}

/// Fills in the settings of the stored blower or attractor that a command names.
Command with_named(Command command, const SceneSettings& settings) {
  if (auto* blow = std::get_if<Blow>(&command); blow && !blow->blower.empty()) {
    for (const NamedBlower& named : settings.blowers) {
      if (named.name != blow->blower) continue;
      Blow filled = named.blow;
      filled.stroke = blow->stroke, filled.brush = blow->brush;
      filled.blower = blow->blower, filled.edit_layer = blow->edit_layer, filled.coats = blow->coats;
      *blow = std::move(filled);
      break;
    }
  }
  if (auto* attract = std::get_if<Attract>(&command); attract && !attract->attractor.empty()) {
    for (const NamedAttractor& named : settings.attractors) {
      if (named.name != attract->attractor) continue;
      Attract filled = named.attract;
      filled.stroke = attract->stroke, filled.brush = attract->brush;
      filled.attractor = attract->attractor, filled.edit_layer = attract->edit_layer;
      filled.coats = attract->coats;
      *attract = std::move(filled);
      break;
    }
  }
  return command;
}

/// Returns whether the command is an erase that removes what an edit layer adds, rather than restoring an earlier
/// state.
bool erases_edit_layer(const Command& command) {
  const auto* erase = std::get_if<Erase>(&command);
  return erase && !erase->edit_layer.empty() && erase->checkpoint.empty() && !erase->revision;
}

/// Evaluates all symmetry images of a command, each as if it were alone, and combines their changes where they overlap.
Evaluation evaluate_all_images(const std::vector<Command>& images, const Surface& surface, const FieldSet& fields,
                               const SceneSettings& settings, const ToolExtras& extras) {
  Evaluation all;
  std::vector<FieldDelta> changes;
  for (const Command& image : images) {
    Evaluation one = evaluate(image, surface, fields, extras);
    changes.push_back(std::move(one.delta));
    all.clamped += one.clamped;
    all.warnings.insert(all.warnings.end(), one.warnings.begin(), one.warnings.end());
  }
  all.delta = stored_in_edit_layer(combine_symmetry_images(changes, fields), edit_layer_of(images.front()),
                                   settings.layers, fields);
  return all;
}

/// Erases what the edit layer adds for all symmetry images, one after the other.
FieldDelta erase_all_images(const std::vector<Command>& images, const Surface& surface, FieldSet fields,
                            const SceneSettings& settings, const ToolExtras& extras) {
  FieldDelta all;
  for (const Command& image : images) {
    const FieldDelta one = erase_edit_layer(std::get<Erase>(image), surface, fields, settings.layers, extras).delta;
    fields.apply(one);
    all = compose(all, one);
  }
  return all;
}

/// Evaluates a tool on one coat.
Evaluation evaluate_coat(const NamedCoat& coat, const std::vector<Command>& images, const Step& step,
                         const Surface& surface, const FieldSet& fields, const SceneSettings& settings,
                         const Cancel& cancel) {
  Evaluation done;
  if (step.baseline && !step.baseline->holds(coat.id)) {
    done.warnings.push_back("the coat " + coat.name +
                            " stays as it is: the groom that is taken has no coat of its number");
    return done;
  }
  std::optional<FieldSet> baseline;
  if (step.baseline) baseline = step.baseline->of_coat(coat.id);
  const ToolExtras extras{
      coat.coat, baseline ? &*baseline : nullptr, step.source.get(), step.pictures.own.get(), step.pictures.alpha.get(),
      cancel};
  const FieldSet own = fields.of_coat(coat.id);
  if (!erases_edit_layer(images.front())) return evaluate_all_images(images, surface, own, settings, extras);
  done.delta = erase_all_images(images, surface, own, settings, extras);
  return done;
}

/// Evaluates a tool on each coat that it works on. Fields that all coats share change as the evaluation of the first of
/// these coats says.
Evaluation evaluate_coats(const Step& step, const Surface& surface, const FieldSet& fields,
                          const SceneSettings& settings, const Cancel& cancel) {
  const std::vector<Command> images = symmetry_images(with_named(step.command, settings), settings.symmetry, surface);
  const std::vector<CoatId> chosen =
      coats_to_groom(coats_of(step.command), edit_layer_of(step.command), settings.coats, settings.layers);
  Evaluation all;
  for (const NamedCoat& coat : settings.coats) {
    if (std::ranges::count(chosen, coat.id) == 0) continue;
    Evaluation one = evaluate_coat(coat, images, step, surface, fields, settings, cancel);
    if (coat.id != chosen.front())
      std::erase_if(one.delta.parts, [](const FieldDelta::Part& part) { return is_shared(part.field); });
    all.delta = all.delta.empty() ? std::move(one.delta) : compose(all.delta, one.delta);
    all.clamped += one.clamped;
    for (std::string& warning : one.warnings)
      if (std::ranges::count(all.warnings, warning) == 0) all.warnings.push_back(std::move(warning));
  }
  return all;
}

/// Evaluates all symmetry images of a command and applies their change to the fields.
Evaluation evaluate_images(const Step& step, const Surface& surface, FieldSet& fields, const SceneSettings& settings,
                           const Cancel& cancel) {
  Evaluation all;
  if (const auto* layer = std::get_if<ChangeEditLayer>(&step.command))
    all.delta = change_edit_layers(*layer, settings.layers, fields);
  else if (const auto* coats = std::get_if<SetCoats>(&step.command))
    all.delta = change_coats(*coats, settings.coats, fields);
  else
    all = evaluate_coats(step, surface, fields, settings, cancel);
  fields.apply(all.delta);
  return all;
}

}  // namespace

Status in_batch(Status status, std::size_t command, std::size_t commands) {
  if (commands > 1) status.pointer.insert(0, "/commands/" + std::to_string(command));
  return status;
}

Status check_complete_stroke(const Command& command) {
  const Stroke* stroke = stroke_of(command);
  if (stroke == nullptr || (stroke->part == 0 && stroke->last)) return {};
  return failure(Code::invalid, "a batch takes whole strokes", "/stroke/part", "0, and the last");
}

std::vector<Command> chosen(const std::vector<Command>& commands, const std::vector<std::size_t>& numbers) {
  std::vector<Command> some;
  some.reserve(numbers.size());
  for (const std::size_t k : numbers) some.push_back(commands[k]);
  return some;
}

CommandResult describe_change(std::string op, const FieldDelta& delta, const FieldSet& fields) {
  CommandResult result;
  result.op = std::move(op);
  result.touched = delta.vertices().size();
  result.fields = measure(delta, fields);
  if (!result.fields.empty()) {
    result.mean_change = result.fields.front().mean_change;
    result.max_change = result.fields.front().max_change;
  }
  return result;
}

namespace {

Outcome evaluate_all(const std::vector<Step>& steps, const FieldDelta& start, const Surface& surface,
                     const FieldSet& before, const SceneSettings& settings, Revision next, const Cancel& cancel) {
  Outcome outcome{before, {}, {}, {}, {}};
  FieldSet& fields = outcome.fields;
  SceneSettings set_so_far = settings;
  bool any_set = false;
  fields.apply(start);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const Stopwatch passed;
    const Evaluation evaluation = evaluate_images(steps[k], surface, fields, set_so_far, cancel);
    const FieldDelta change = k == 0 ? compose(start, evaluation.delta) : evaluation.delta;
    outcome.delta = compose(outcome.delta, change);
    outcome.results.push_back(describe_change(op_of(steps[k].command), change, fields));
    outcome.results.back().clamped = evaluation.clamped;
    std::vector<std::string>& warnings = outcome.results.back().warnings;
    warnings = warnings_of(steps[k].command, surface);
    warnings.insert(warnings.end(), evaluation.warnings.begin(), evaluation.warnings.end());
    if (warnings.empty() && change.empty()) warnings = warnings_of_no_change(steps[k].command);
    outcome.results.back().milliseconds = passed.milliseconds();
    const bool setting = set(steps[k].command, set_so_far, next);
    any_set = any_set || setting;
    if (setting || !change.empty()) outcome.effective.push_back(k);
  }
  if (any_set) outcome.settings = std::make_shared<const SceneSettings>(std::move(set_so_far));
  return outcome;
}

}  // namespace

Result<Outcome> evaluate_batch(const std::vector<Step>& steps, const FieldDelta& start, const Surface& surface,
                               const FieldSet& fields, const SceneSettings& settings, Revision next,
                               const Cancel& cancel) {
  try {
    return evaluate_all(steps, start, surface, fields, settings, next, cancel);
  } catch (const Cancelled&) {
    return nobody_waits();
  }
}

Status check_cost(const std::vector<Step>& steps, Symmetry symmetry, const Surface& surface, const FieldSet& fields) {
  const double longest = longest_fur_of_all(fields);
  double visits = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    if (const auto* set = std::get_if<SetSymmetry>(&steps[k].command)) symmetry = set->symmetry;
    const std::size_t named = coats_of(steps[k].command).size();
    for (std::size_t coat = 0; coat < (named > 0 ? named : fields.coats()); ++coat) {
      if (Status refused = add_cost(steps[k].command, symmetry, surface, longest, visits); !refused.ok())
        return in_batch(refused, k, steps.size());
    }
  }
  return {};
}

}  // namespace pelage
