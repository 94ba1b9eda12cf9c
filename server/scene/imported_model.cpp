#include "server/scene/imported_model.h"

#include <algorithm>

#include "protocol/json/names.h"

namespace pelage {

namespace {

/// Returns the options of the preparation. Axes that were not asked for follow from the file, and are chosen so that up
/// and front never lie on one line.
PrepareOptions preparation_of(const ImportOptions& asked, const RawModel& raw) {
  const auto line = [](Axis axis) { return static_cast<int>(axis) / 2; };
  PrepareOptions options{.source_is_32_bit = raw.is_32_bit, .crease_degrees = asked.crease_degrees};
  options.up = asked.up.value_or(raw.up.value_or(Axis::plus_y));
  if (!asked.up && asked.front && line(options.up) == line(*asked.front))
    options.up = line(*asked.front) == line(Axis::plus_y) ? Axis::plus_z : Axis::plus_y;
  options.front = asked.front.value_or(raw.front.value_or(Axis::plus_z));
  if (line(options.front) == line(options.up))
    options.front = options.up == Axis::plus_z ? Axis::minus_y : Axis::plus_z;
  if (line(options.front) == line(options.up)) options.front = Axis::plus_y;  // -Z is up
  options.flipped_parts.assign(asked.flip.begin(), asked.flip.end());
  options.two_sided_parts.assign(asked.two_sided.begin(), asked.two_sided.end());
  return options;
}

}  // namespace

ImportLimits cancellable_limits(const Cancel& cancel) {
  return {.cancelled = [cancel] { return cancel.asked(); }};
}

ImportOptions with_axes_of(const SceneModel& before, ImportOptions asked) {
  const auto& formats = json_names::model_formats;
  const bool is_file =
      std::any_of(formats.begin(), formats.end(), [&](const auto& one) { return before.name == one.text; });
  if (!is_file || asked.up || asked.front) return asked;
  asked.up = before.surface.mesh().report.up, asked.front = before.surface.mesh().report.front;
  return asked;
}

Result<ImportedModel> import_for_scene(const std::string& worker, std::uint64_t id, const ImportOptions& options,
                                       std::span<const std::byte> bytes, const Cancel& cancel,
                                       std::vector<ChosenTriangles> subdivisions) {
  const Result<RawModel> raw = import_model(worker, options.format, bytes, options.pose, cancellable_limits(cancel));
  if (!raw) return raw.status();
  StoredModel how{.name = json_names::word_of(json_names::model_formats, options.format),
                  .prepare = preparation_of(options, *raw),
                  .raw = {},
                  .fur_patches = options.fur_patches,
                  .subdivisions = std::move(subdivisions)};
  cancel.check();
  auto model = build_model(*raw, how, id);
  if (!model) return model.status();
  cancel.check();
  how.raw = encode_raw_model(*raw);
  return ImportedModel{std::move(*model), std::move(how)};
}

}  // namespace pelage
