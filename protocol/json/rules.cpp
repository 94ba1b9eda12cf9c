#include "protocol/json/rules.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

namespace pelage::json_parts {

namespace {

bool given(const Value& value, const char* name) { return value.tree().is_object() && value.tree().contains(name); }

/// Refuses what the chosen method cannot do.
void check_drawing(const Value& value, const FrameRequest& request) {
  const Method method = request.knobs.method;
  if (method != Method::raster && request.progressive)
    value.refuse_below("progressive", "Progressive pictures begin with rasterized strands.", "method raster");
  const auto names_strands = [](Aov aov) { return aov == Aov::strand || aov == Aov::root; };
  if (method == Method::strands && std::any_of(request.aovs.begin(), request.aovs.end(), names_strands))
    value.refuse_below("aovs", "Only rasterized strands have these AOVs.", "method raster");
  if (method != Method::shells) return;
  if (request.overlay != Overlay::none)
    value.refuse_below("overlay", "Shells have no overlays.", "none, or method raster or strands");
  const auto drawn = [](Aov aov) { return aov == Aov::beauty || aov == Aov::alpha; };
  if (!std::all_of(request.aovs.begin(), request.aovs.end(), drawn))
    value.refuse_below("aovs", "Shells have no such AOV.", "beauty and alpha, or method raster or strands");
}

/// Refuses progressive pictures of earlier revisions, which never get better.
void check_past(const Value& value, const FrameRequest& request) {
  if (request.revision && request.progressive)
    value.refuse_below("progressive", "Only the present revision has progressive pictures.", "without revision");
}

/// Refuses more than one way to choose the knobs: by quality, by budget and by error.
void check_dial(const Value& value, const FrameRequest& request) {
  const bool two_goals = request.budget_ms && request.max_error;
  if (two_goals || (request.plans() && given(value, "quality"))) {
    value.refuse_below(request.max_error ? "max_error" : "budget_ms", "Only one of them can choose the quality.",
                       "one of quality, budget_ms and max_error");
  }
}

void check_size(const Value& value, const FrameRequest& request) {
  const double width = request.width * request.knobs.scale, height = request.height * request.knobs.scale;
  if (std::max(width, height) > limits::frame_pixels) {
    value.refuse_below("quality", "The quality's scale renders the frame too large.",
                       "scale x width and scale x height at most " + std::to_string(limits::frame_pixels));
  }
  const Layering& shells = request.knobs.shells;
  const bool sorted = request.knobs.method == Method::shells && shells.order == FragmentOrder::sorted;
  const Crop drawn = request.crop.value_or(Crop{.width = request.width, .height = request.height});
  const double pixels = request.knobs.scale * drawn.width * request.knobs.scale * drawn.height;
  if (sorted && pixels * shells.count > limits::sorted_fragments) {
    value.refuse_below("quality", "The frame is too large to be sorted at once.",
                       "drawn pixels x shells at most " + std::to_string(limits::sorted_fragments) +
                           "; a crop or the tiles of a job draw fewer");
  }
}

void check_crop(const Value& value, const FrameRequest& request) {
  if (!request.crop) return;
  const Crop& crop = *request.crop;
  if (crop.left + crop.width > request.width || crop.top + crop.height > request.height) {
    value.refuse_below("crop", "The part ends outside the frame.",
                       "left + width at most " + std::to_string(request.width) + ", top + height at most " +
                           std::to_string(request.height));
  }
}

void check_aovs(const Value& value, const FrameRequest& request) {
  const double width = request.width * request.knobs.scale, height = request.height * request.knobs.scale;
  const bool linear = is_linear(request.format);
  if (given(value, "aovs") && !linear)
    value.refuse_below("aovs", "Only linear light has AOVs.", "format exr or npy_linear");
  if (!request.colour_space.empty() && !linear)
    value.refuse_below("colour_space", "Only linear light has a colour space of its own.", "format exr or npy_linear");
  const bool colour_only = request.aovs == std::vector{Aov::beauty};
  const int pictures = std::transform_reduce(request.aovs.begin(), request.aovs.end(), 0, std::plus<>(), pictures_of);
  if (linear && !colour_only && width * height * pictures > limits::aov_pixels) {
    value.refuse_below("aovs", "The AOVs are too large together.",
                       "drawn pixels x AOVs at most " + std::to_string(limits::aov_pixels));
  }
}

void check_overlay(const Value& value, const FrameRequest& request) {
  if (is_linear(request.format) && request.overlay != Overlay::none) {
    value.refuse_below("overlay", "Linear light has no overlay.", "format png, png16, jpeg, webp or npy");
  }
  const bool compares = request.overlay == Overlay::difference;
  if (compares && !request.overlay_from) {
    value.refuse_below("overlay_from", "A picture of a difference needs the revision to compare with.", "required");
  }
  if (!compares && request.overlay_from) {
    value.refuse_below("overlay_from", "Only the overlay difference compares revisions.", "overlay difference");
  }
  if (request.format == FrameFormat::jpeg && request.background == Background::transparent) {
    value.refuse_below("background", "JPEG has no alpha.", "a colour or studio");
  }
}

/// Refuses members that belong to another method.
void check_method(const Value& value, const Knobs& knobs) {
  const bool traced = knobs.method == Method::strands, layered = knobs.method == Method::shells;
  if (traced && given(value, "scale"))
    value.refuse_below("scale", "Traced strands have no scale.", "method raster or shells");
  if (layered && given(value, "eye_steps"))
    value.refuse_below("eye_steps", "Shells are drawn without eyes.", "method raster or strands");
  if (!traced && given(value, "trace")) value.refuse_below("trace", "Only method strands traces.", "method strands");
  if (!layered && given(value, "shells")) value.refuse_below("shells", "Strands have no shells.", "method shells");
  if (knobs.method != Method::raster && given(value, "raster"))
    value.refuse_below("raster", "Only method raster rasterizes strands.", "method raster");
}

}  // namespace

void check(const Value& value, const PickFarthest& farthest) {
  if (farthest.min.has_value() != farthest.max.has_value())
    return value.refuse_below(farthest.min ? "max" : "min", "A box has two corners.", "required");
  if (farthest.min && !glm::all(glm::lessThanEqual(*farthest.min, *farthest.max)))
    value.refuse_below("max", "The highest corner of a box is nowhere below its lowest.", "min or more, on each axis");
}

void check(const Value& value, const FrameRequest& request) {
  check_dial(value, request);
  check_drawing(value, request);
  check_size(value, request);
  check_crop(value, request);
  check_aovs(value, request);
  check_overlay(value, request);
  check_past(value, request);
}

void check(const Value& value, const Knobs& knobs) { check_method(value, knobs); }

void set_dependent_defaults(const Value& value, Tracing& tracing) {
  if (tracing.transport == Transport::paths && !given(value, "scattering"))
    tracing.scattering = StrandScattering::energy_conserving;
}

void check(const Value& value, const Tracing& tracing) {
  const bool paths = tracing.transport == Transport::paths;
  if (paths && tracing.scattering == StrandScattering::look)
    value.refuse_below("scattering", "Paths need a scattering model that conserves energy.", "energy_conserving");
  if (!paths && given(value, "bounces")) value.refuse_below("bounces", "Only paths have bounces.", "transport paths");
}

void set_dependent_defaults(const Value& value, Camera& camera) {
  if (!given(value, "auto")) camera.automatic = AutoView::none;
}

void check(const Value& value, const Camera& camera) {
  if (camera.automatic != AutoView::none) return;
  const glm::dvec3 forward = camera.target - camera.position;
  if (!(glm::length(forward) > 0)) {
    value.refuse("The camera is at its target.", "position differs from target");
  } else if (glm::length(glm::cross(glm::normalize(forward), glm::normalize(camera.up))) < 1e-6) {
    value.refuse_below("up", "Up points along the view.", "not along the view");
  }
}

void check(const Value& value, const Stroke& stroke) {
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    const StrokeSample& sample = stroke.samples[i];
    const std::string name = "samples/" + std::to_string(i);
    if (i > 0 && sample.time < stroke.samples[i - 1].time) {
      value.refuse_below(name + "/time", "Time falls from one sample to the next.", "not falling");
    }
    if (!stroke.view && std::holds_alternative<ScreenSample>(sample.position)) {
      value.refuse_below("view", "Pixel samples need the view that they were drawn on.", "required");
    }
  }
}

void check(const Value& value, const Coat& coat) {
  for (std::size_t i = 1; i < coat.ramp.size(); ++i) {
    if (!(coat.ramp[i].at > coat.ramp[i - 1].at))
      value.refuse_below("ramp/" + std::to_string(i) + "/at", "The ramp does not rise.", "above the stop before");
  }
}

void check(const Value& value, const Environment& environment) {
  const bool gradient = given(value, "sky") || given(value, "horizon") || given(value, "ground");
  if (environment.harmonics && gradient) {
    value.refuse_below("harmonics", "Harmonics and the colours of a gradient exclude each other.",
                       "harmonics, or sky, horizon and ground");
  } else if (!environment.harmonics && given(value, "turn_degrees")) {
    value.refuse_below("turn_degrees", "A gradient is the same however it is turned.", "with harmonics only");
  }
}

void check(const Value& value, const Eye& eye) {
  if (!eye.look_at) return;
  if (given(value, "gaze")) value.refuse_below("gaze", "An eye takes a gaze or a point to look at.", "gaze | look_at");
  if (*eye.look_at == eye.position)
    value.refuse_below("look_at", "The eye cannot look at its own centre.", "differs from position");
}

void check(const Value& value, const ImportOptions& options) {
  const auto line = [](Axis axis) { return static_cast<int>(axis) / 2; };  // x, y or z, whatever the sign
  if (options.up && options.front && line(*options.up) == line(*options.front))
    value.refuse_below("front", "Up and front lie on one line.", "another axis than up");
}

void check(const Value& value, const MapUpload& map) {
  refuse_encoding(value, map.field, map.encoding);
  refuse_tile(value, map.tile, map.encoding);
}

void check(const Value& value, const ParameterKeys& keys) {
  for (std::size_t k = 1; k < keys.keys.size(); ++k) {
    if (keys.keys[k].frame > keys.keys[k - 1].frame) continue;
    value.refuse_below("keys/" + std::to_string(k) + "/frame", "The frames of keys ascend.", "above the frame before");
  }
}

void check(const Value& value, const RenderJob& job) {
  if (job.output.empty()) value.refuse_below("output", "The job says no file to write.", "as out/fox.####.png");
  if (job.scene.empty() == !job.builtin)
    value.refuse_below("scene", "A job has either a file of a scene or a built-in model.", "either scene or builtin");
  if (job.options && job.builtin) value.refuse_below("options", "Options are of a model's file.", "without builtin");
}

void check(const Value& value, const MapRequest& map) {
  refuse_encoding(value, map.field, map.encoding);
  const bool is_png = map.format == MapFormat::png || map.format == MapFormat::png16;
  if (map.encoding == MapEncoding::vector && is_png)
    value.refuse_below("format", "Vectors have parts below 0 and need floats.", "exr | exr_half | npy");
  if (map.encoding == MapEncoding::vertices && map.format != MapFormat::npy)
    value.refuse_below("format", "A list of all vertices is no picture.", "npy");
  refuse_tile(value, map.tile, map.encoding);
}

void refuse_tile(const Value& value, int tile, MapEncoding encoding) {
  if (tile != 0 && tile < first_udim)
    value.refuse_below("tile", "UDIM tiles are numbered from 1001.", "0, or [1001, 9999]");
  if (tile != 0 && encoding == MapEncoding::vertices)
    value.refuse_below("tile", "A list of all vertices has no tiles.", "0");
}

void refuse_encoding(const Value& value, Field field, MapEncoding encoding) {
  if (fits(field, encoding)) return;
  const bool direction = field == Field::direction;
  value.refuse_below("encoding", "The encoding cannot hold this field.",
                     direction ? "uv_tangent | fast_fur | vector | vertices for direction"
                               : "value | vertices for all fields but direction");
}

void check(const Value& value, const ExportRequest& wanted) {
  for (const char* name : {"every", "widen", "curves"}) {
    if (given(value, name) && !holds_strands(wanted.format))
      value.refuse_below(name, "The format holds no strands.", "format usda or hair");
  }
  if (given(value, "shells") && wanted.format != ExportFormat::shells)
    value.refuse_below("shells", "The format has no shells.", "format shells");
  if (given(value, "cards") && wanted.format != ExportFormat::cards)
    value.refuse_below("cards", "The format has no cards.", "format cards");
  for (const char* name : {"basis", "skin"}) {
    if (given(value, name) && wanted.format != ExportFormat::usda)
      value.refuse_below(name, "Only USD holds that.", "format usda");
  }
  if (given(value, "frame") && wanted.format == ExportFormat::pelage)
    value.refuse_below("frame", "The format keeps the scene with its axes.", "another format");
  const bool has_unit = wanted.format != ExportFormat::pelage && wanted.format != ExportFormat::hair;
  if (given(value, "metres_per_unit") && !has_unit)
    value.refuse_below("metres_per_unit", "The format says no unit.", "format usda, shells, cards or fields");
}

// Rules between the members of commands.

namespace {

/// Refuses a tool that can flood, unless it has either a stroke or a flood.
template <class Tool>
void check_reach(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.flood; }) {
    if (tool.flood == tool.stroke.has_value())
      value.refuse_below("stroke", "The tool takes a stroke, or \"flood\": true.", "one of stroke | flood");
  }
}

bool needs_view(const Brush& brush) {
  return brush.units == RadiusUnits::pixels || brush.falloff_shape == FalloffShape::screen;
}

template <class Tool>
void check_view(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.brush; }) {
    if (tool.stroke && !tool.stroke->view && needs_view(tool.brush))
      value.refuse_below("stroke/view", "A radius in pixels and the screen shape need a view.", "required");
  }
}

bool is_colour(Field field) { return shape_of(field).channels == 4; }
bool are_colours(const std::vector<Field>& fields) {
  return !fields.empty() && std::all_of(fields.begin(), fields.end(), is_colour);
}

/// Returns whether the tool changes colours only; no other field differs from root to tip.
template <class Tool>
bool changes_colours_only(const Tool& tool) {
  if constexpr (requires { tool.field; }) return is_colour(tool.field);
  if constexpr (requires { tool.fields; }) return are_colours(tool.fields);
  return false;
}
bool changes_colours_only(const Unify& unify) {
  return are_colours(unify.mean) && !unify.direction && !unify.inclination && !unify.length;
}

bool names_mask(Field field) { return field == Field::mask; }
bool names_mask(const std::vector<Field>& fields) { return std::count(fields.begin(), fields.end(), Field::mask) > 0; }

/// Refuses an edit layer if the mask is changed, which belongs to no edit layer.
template <class Tool>
void check_layer(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.edit_layer; }) {
    bool mask = false;
    if constexpr (requires { tool.field; }) mask = mask || names_mask(tool.field);
    if constexpr (requires { tool.fields; }) mask = mask || names_mask(tool.fields);
    if constexpr (requires { tool.mean; }) mask = mask || names_mask(tool.mean);
    if (mask && !tool.edit_layer.empty())
      value.refuse_below("edit_layer", "The mask belongs to no edit layer.", "no edit layer for the mask");
  }
}

/// Refuses a list of coats with duplicates or too many names.
template <class Tool>
void check_coats(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.edit_layer; }) {
    const std::set<std::string> names(tool.coats.begin(), tool.coats.end());
    if (tool.coats.size() > limits::coats || names.size() != tool.coats.size())
      value.refuse_below("coats", "Each coat is named once.", "at most " + std::to_string(limits::coats) + " names");
  }
}

template <class Tool>
void check_brush(const Value& value, const Tool& tool) {
  if constexpr (requires { tool.brush; }) {
    const Brush& brush = tool.brush;
    if (brush.invert && Tool::opposite == Opposite::no)
      value.refuse_below("brush/invert", "The tool has no opposite.", "false");
    if (brush.reach == Reach::fur && brush.falloff_shape != FalloffShape::volume)
      value.refuse_below("brush/reach", "The distance to strands is measured through space.",
                         "skin, or falloff_shape volume");
    if (brush.strand_to <= brush.strand_from)
      value.refuse_below("brush/strand_to", "The part of the strand ends before it begins.", "above strand_from");
    if ((brush.strand_from > 0 || brush.strand_to < 1) && !changes_colours_only(tool)) {
      value.refuse_below("brush/strand_from", "Only colours differ from root to tip.",
                         "0 to 1, or a tool that changes nothing but root_colour and tip_colour");
    }
  }
}

void check(const Value& value, const Comb& comb) {
  if (comb.flood != comb.direction.has_value()) {
    value.refuse_below("direction", "A flooding comb needs a direction, and a stroke brings its own.",
                       "with flood only");
  }
}

void check(const Value& value, const Blow& blow) {
  const bool own = value.tree().contains("source");
  if (blow.blower.empty() != own)
    value.refuse_below("source", "Wind has a source, or the name of a blower.", "one of source | blower");
}

void check(const Value& value, const Attract& attract) {
  const bool own = value.tree().contains("point");
  if (attract.attractor.empty() != own)
    value.refuse_below("point", "A stick has a point, or the name of an attractor.", "one of point | attractor");
}

void check(const Value& value, const Interpolate& command) {
  for (std::size_t k = 0; k < command.keys.size(); ++k) {
    const Key& key = command.keys[k];
    const std::string pointer = "keys/" + std::to_string(k);
    if (!key.direction && !key.length)
      value.refuse_below(pointer, "A key gives a direction or a length.", "direction | length");
    if (!key.direction && key.inclination)
      value.refuse_below(pointer + "/inclination", "An inclination comes with a direction.", "with direction only");
  }
}

void check(const Value& value, const Unify& unify) {
  if (!unify.direction && !unify.inclination && !unify.length && unify.mean.empty())
    value.refuse("The command names nothing to unify.", "one or more of direction | inclination | length | mean");
  const auto has = [&](Field field) { return std::count(unify.mean.begin(), unify.mean.end(), field) > 0; };
  if ((has(Field::direction) && (unify.direction || unify.inclination)) || (has(Field::length) && unify.length))
    value.refuse_below("mean", "A field goes to its mean or to a value.", "fields without a value");
}

void check(const Value& value, const Length& length) {
  const bool jitter = length.mode == LengthMode::jitter;
  if (length.mode != LengthMode::add && length.value < 0)
    value.refuse_below("value", "Only add takes a value below 0.", "at least 0");
  if (jitter && length.value > 1) value.refuse_below("value", "A jitter is a share of the length.", "[0, 1]");
}

void check(const Value& value, const Trim&) {
  const auto& tree = value.tree();
  if (!tree.contains("plane") && !tree.contains("sphere") && !tree.contains("height"))
    value.refuse("Nothing says where fur ends.", "one of plane | sphere | height");
}

void check(const Value& value, const Erase& erase) {
  if (!erase.checkpoint.empty() && erase.revision)
    value.refuse_below("revision", "A checkpoint and a revision exclude each other.", "one of checkpoint | revision");
}

void check(const Value& value, const Paint& paint) {
  const FieldShape& shape = shape_of(paint.field);
  const Field unpaintable[] = {Field::direction, Field::length, Field::stretch};
  if (std::count(std::begin(unpaintable), std::end(unpaintable), paint.field) > 0)
    value.refuse_below("field", "Other tools change this field.",
                       "density | width | curl | clump | wetness | bare | mask | root_colour | tip_colour | stiffness");
  if (paint.value > shape.max) value.refuse_below("value", "The value is beyond the field's range.", "[0, 1]");
}

void check(const Value& value, const ChangeMask& mask) {
  if (const auto* box = std::get_if<MaskBox>(&mask.shape); box && glm::any(glm::greaterThan(box->min, box->max)))
    value.refuse_below("box/max", "The box ends before it begins.", "at least min");
}

void check(const Value& value, const ApplyMap& map) {
  refuse_encoding(value, map.field, map.encoding);
  refuse_tile(value, map.tile, map.encoding);
}

template <class T>
void check_names(const Value& value, const char* list, const std::vector<T>& named) {
  for (std::size_t k = 0; k < named.size(); ++k) {
    const auto twin = std::find_if(named.begin(), named.begin() + static_cast<std::ptrdiff_t>(k),
                                   [&](const T& other) { return other.name == named[k].name; });
    if (twin != named.begin() + static_cast<std::ptrdiff_t>(k))
      value.refuse_below(std::string(list) + "/" + std::to_string(k) + "/name", "The name is taken.", "each name once");
  }
}

void check(const Value& value, const SetBlowers& c) { check_names(value, "blowers", c.blowers); }
void check(const Value& value, const SetAttractors& c) { check_names(value, "attractors", c.attractors); }

void check(const Value& value, const SetCoats& command) {
  check_names(value, "coats", command.coats);
  std::set<std::uint64_t> ids;
  for (std::size_t k = 0; k < command.coats.size(); ++k) {
    const std::optional<std::uint64_t>& id = command.coats[k].id;
    if (!id || (*id < limits::coats && ids.insert(*id).second)) continue;
    value.refuse_below("coats/" + std::to_string(k) + "/id", "A coat has a number of its own.",
                       "[0, " + std::to_string(limits::coats - 1) + "], each once");
  }
  if (std::ranges::all_of(command.coats, &CoatEntry::muted))
    value.refuse_below("coats", "One coat at least is seen.", "one that is not muted");
}

void check(const Value& value, const SetCurves& command) {
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < command.groups.size(); ++k) {
    count += curve_count(command.groups[k]);
    if (count > limits::curves)
      value.refuse_below("groups/" + std::to_string(k), "These are too many curves.",
                         "at most " + std::to_string(limits::curves) + " in all groups");
  }
}

void check(const Value& value, const ChangeEditLayer& layer) {
  if (layer.action == EditLayerAction::set && !layer.weight && !layer.muted && layer.rename.empty())
    value.refuse("The command sets nothing of the edit layer.", "one or more of weight | muted | rename");
  if (layer.action == EditLayerAction::move && !layer.above)
    value.refuse_below("above", "The command does not say where the edit layer moves to.", "required");
  if (layer.above == layer.name) value.refuse_below("above", "An edit layer cannot lie on itself.", "another layer");
}

}  // namespace

void check_command(const Value& value, const Command& command) {
  std::visit(
      [&](const auto& tool) {
        check_reach(value, tool);
        check_view(value, tool);
        check_brush(value, tool);
        check_layer(value, tool);
        check_coats(value, tool);
        check(value, tool);
      },
      command);
}

}  // namespace pelage::json_parts
