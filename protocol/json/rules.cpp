#include "protocol/json/rules.h"

#include <algorithm>

namespace pelage::json_parts {

namespace {

bool given(const Value& value, const char* name) { return value.tree().is_object() && value.tree().contains(name); }

/// What shells draw and strands do not.
void check_strands(const Value& value, const FrameRequest& request) {
  const bool strands = request.knobs.method == Method::strands;
  if (strands && request.progressive) {
    value.refuse_below("progressive", "Strands improve what shells have drawn.", "a quality of shells");
  }
  const Overlay overlay = request.overlay;
  const bool of_shells = overlay == Overlay::shell_count || overlay == Overlay::light_depth ||
                         overlay == Overlay::light_occlusion || overlay == Overlay::shadow_width;
  if ((strands || request.progressive) && of_shells) {
    value.refuse_below("overlay", "Traced strands have no such map.", "a field, or method shells without progressive");
  }
}

/// Knobs are named, or chosen by what they may cost, or by how far they may be off.
void check_dial(const Value& value, const FrameRequest& request) {
  const bool two_goals = request.budget_ms && request.max_error;
  if (two_goals || (request.plans() && given(value, "quality"))) {
    value.refuse_below(request.max_error ? "max_error" : "budget_ms", "One of them chooses the quality.",
                       "one of quality, budget_ms and max_error");
  }
}

void check_size(const Value& value, const FrameRequest& request) {
  const double width = request.width * request.knobs.scale, height = request.height * request.knobs.scale;
  if (std::max(width, height) > limits::frame_pixels) {
    value.refuse_below("quality", "The quality's scale renders the frame too large.",
                       "scale x width and scale x height at most " + std::to_string(limits::frame_pixels));
  }
  const bool sorted = request.knobs.order == FragmentOrder::sorted;
  if (sorted && width * height * request.knobs.shells > limits::sorted_fragments) {
    value.refuse_below("quality", "The frame is too large to be sorted.",
                       "drawn pixels x shells at most " + std::to_string(limits::sorted_fragments));
  }
}

void check_layers(const Value& value, const FrameRequest& request) {
  const double width = request.width * request.knobs.scale, height = request.height * request.knobs.scale;
  const bool exr = request.format == FrameFormat::exr;
  if (given(value, "aovs") && !exr) value.refuse_below("aovs", "Only an EXR has AOVs.", "format exr");
  const bool colour_only = request.aovs == std::vector{Aov::beauty};
  if (exr && !colour_only && width * height * static_cast<double>(request.aovs.size()) > limits::aov_pixels) {
    value.refuse_below("aovs", "The AOVs are too large together.",
                       "drawn pixels x AOVs at most " + std::to_string(limits::aov_pixels));
  }
}

void check_overlay(const Value& value, const FrameRequest& request) {
  if (request.format == FrameFormat::exr && request.overlay != Overlay::none) {
    value.refuse_below("overlay", "An EXR has no overlay.", "format png, png16 or jpeg");
  }
  const bool compares = request.overlay == Overlay::difference;
  if (compares && !request.overlay_from) {
    value.refuse_below("overlay_from", "A picture of a difference needs the revision to compare with.", "required");
  }
  if (!compares && request.overlay_from) {
    value.refuse_below("overlay_from", "Only a picture of a difference compares.", "overlay difference");
  }
  if (request.format == FrameFormat::jpeg && request.background == Background::transparent) {
    value.refuse_below("background", "JPEG has no alpha.", "a colour or studio");
  }
}

/// Of shells alone, or of strands alone.
void check_method(const Value& value, const Knobs& knobs) {
  const bool strands = knobs.method == Method::strands;
  for (const char* name : {"shells", "shell_policy", "steps", "scale", "min_radius", "self_shadow", "shadow_maps",
                           "shadow_resolution", "order", "fins"}) {
    if (strands && given(value, name)) value.refuse_below(name, "Traced strands have no shells.", "method shells");
  }
  if (!strands && given(value, "trace")) value.refuse_below("trace", "Only strands are traced.", "method strands");
}

}  // namespace

void check(const Value& value, const FrameRequest& request) {
  check_dial(value, request);
  check_strands(value, request);
  check_size(value, request);
  check_layers(value, request);
  check_overlay(value, request);
}

void check(const Value& value, const Knobs& knobs) { check_method(value, knobs); }

void settle(const Value& value, Tracing& tracing) {
  if (tracing.transport == Transport::paths && !given(value, "scattering"))
    tracing.scattering = StrandScattering::energy_conserving;
}

void check(const Value& value, const Tracing& tracing) {
  const bool paths = tracing.transport == Transport::paths;
  if (paths && tracing.scattering == StrandScattering::look)
    value.refuse_below("scattering", "Paths need a model that makes no light.", "energy_conserving");
  if (!paths && given(value, "bounces")) value.refuse_below("bounces", "Only paths bounce.", "transport paths");
}

void settle(const Value& value, Camera& camera) {
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

void check(const Value& value, const CalibratedKnobs& row) {
  if (row.knobs.method != Method::shells) value.refuse_below("knobs/method", "The ladder is of shells.", "shells");
}

void check(const Value& value, const Stroke& stroke) {
  for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
    const StrokeSample& sample = stroke.samples[i];
    const std::string name = "samples/" + std::to_string(i);
    if (i > 0 && sample.time < stroke.samples[i - 1].time) {
      value.refuse_below(name + "/time", "Time falls from one sample to the next.", "not falling");
    }
    if (!stroke.view && std::holds_alternative<ScreenSample>(sample.place)) {
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
  const int up_line = static_cast<int>(options.up) / 2;  // x, y or z, whatever the sign
  const int front_line = static_cast<int>(options.front) / 2;
  if (up_line == front_line) value.refuse_below("front", "Up and front lie on one line.", "another axis than up");
}

void check(const Value& value, const MapUpload& map) { refuse_encoding(value, map.field, map.encoding); }

void check(const Value& value, const MapRequest& map) {
  refuse_encoding(value, map.field, map.encoding);
  const bool is_png = map.format == MapFormat::png || map.format == MapFormat::png16;
  if (map.encoding == MapEncoding::vector && is_png)
    value.refuse_below("format", "Vectors have parts below 0 and need floats.", "exr | exr_half");
}

void refuse_encoding(const Value& value, Field field, MapEncoding encoding) {
  if (fits(field, encoding)) return;
  const bool direction = field == Field::direction;
  value.refuse_below("encoding", "The encoding cannot hold this field.",
                     direction ? "uv_tangent | fast_fur | vector for direction" : "value for all fields but direction");
}

}  // namespace pelage::json_parts
