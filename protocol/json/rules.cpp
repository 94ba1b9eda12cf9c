#include "protocol/json/rules.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

namespace pelage::json_parts {

namespace {

bool given(const Value& value, const char* name) { return value.tree().is_object() && value.tree().contains(name); }

/// Refuses a member that was given although it has no meaning here.
void refuse_given(const Value& value, const char* name, const char* why, const char* limit) {
  if (given(value, name)) value.refuse_below(name, why, limit);
}

/// Refuses what the chosen method cannot do.
void check_drawing(const Value& value, const FrameRequest& request) {
  const Method method = request.knobs.method;
  if (method != Method::raster && request.progressive)
    value.refuse_below("progressive", "Progressive pictures begin with rasterized strands.", "method raster");
  const auto names_strands = [](Aov aov) { return aov == Aov::strand || aov == Aov::root; };
  const bool traced = method == Method::strands || request.progressive;
  if (traced && std::any_of(request.aovs.begin(), request.aovs.end(), names_strands))
    value.refuse_below("aovs", "Only rasterized strands have these AOVs.", "method raster, without progressive");
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
  if (!linear) refuse_given(value, "aovs", "Only linear light has AOVs.", "format exr or npy_linear");
  if (!request.colour_space.empty() && !linear)
    value.refuse_below("colour_space", "Only linear light has a colour space of its own.", "format exr or npy_linear");
  const bool colour_only = request.aovs == std::vector{Aov::beauty};
  const int pictures = std::transform_reduce(request.aovs.begin(), request.aovs.end(), 0, std::plus<>(), pictures_of);
  if (linear && !colour_only && width * height * pictures > limits::aov_pixels) {
    value.refuse_below("aovs", "The AOVs are too large together: fewer of them, or a smaller picture, would fit.",
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
  if (traced) refuse_given(value, "scale", "Traced strands have no scale.", "method raster or shells");
  if (layered) refuse_given(value, "eye_steps", "Shells are drawn without eyes.", "method raster or strands");
  if (!traced) refuse_given(value, "trace", "Only method strands traces.", "method strands");
  if (!layered) refuse_given(value, "shells", "Strands have no shells.", "method shells");
  if (knobs.method != Method::raster)
    refuse_given(value, "raster", "Only method raster rasterizes strands.", "method raster");
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
  if (!paths) refuse_given(value, "bounces", "Only paths have bounces.", "transport paths");
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
  } else if (!environment.harmonics) {
    refuse_given(value, "turn_degrees", "A gradient is the same however it is turned.", "with harmonics only");
  }
}

void check(const Value& value, const Eye& eye) {
  if (!eye.look_at) return;
  refuse_given(value, "gaze", "An eye takes a gaze or a point to look at.", "gaze | look_at");
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
  if (!holds_strands(wanted.format)) {
    for (const char* name : {"every", "widen", "curves"})
      refuse_given(value, name, "The format holds no strands.", "format usda or hair");
  }
  if (wanted.format != ExportFormat::shells)
    refuse_given(value, "shells", "The format has no shells.", "format shells");
  if (wanted.format != ExportFormat::cards) refuse_given(value, "cards", "The format has no cards.", "format cards");
  if (wanted.format != ExportFormat::usda) {
    for (const char* name : {"basis", "skin"}) refuse_given(value, name, "Only USD holds that.", "format usda");
  }
  if (wanted.format == ExportFormat::pelage)
    refuse_given(value, "frame", "The format keeps the scene with its axes.", "another format");
  if (wanted.format == ExportFormat::pelage || wanted.format == ExportFormat::hair)
    refuse_given(value, "metres_per_unit", "The format says no unit.", "format usda, shells, cards or fields");
}

}  // namespace pelage::json_parts
