#include "clients/cli/trade/shoot.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

#include "protocol/base/colour_space.h"
#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "renderer/image/image.h"

namespace pelage::trade {

namespace {

constexpr std::size_t max_pixels = std::size_t{1} << 26;
constexpr int jpeg_quality = 84;
constexpr double paper = 0.35;  // linear grey behind the pictures of the report

Result<HttpAnswer> draw(Session& session, const Place& place, const Knobs& knobs, FrameFormat format) {
  FrameRequest request = place.request;
  request.knobs = knobs, request.format = format, request.exr_type = ExrType::single;
  return Session::accepted(session.connection().post_json(place.scene_path + "/frames", encode(request)));
}

void measure(Shot& shot) {
  double sum = 0;
  for (std::size_t i = 0; i < shot.picture.rgba.size(); i += 4) {
    const float* p = &shot.picture.rgba[i];
    if (!std::all_of(p, p + 4, [](float value) { return std::isfinite(value); })) {
      ++shot.non_finite;
      continue;
    }
    sum += luminance(glm::dvec3(p[0], p[1], p[2]));
    shot.coverage += double{p[3]};
  }
  shot.luminance = shot.coverage > 0 ? sum / shot.coverage : 0;
}

}  // namespace

double timing_of(std::string_view header, std::string_view entry) {
  for (std::size_t at = 0; at < header.size();) {
    const std::size_t end = std::min(header.find(',', at), header.size());
    std::string_view part = header.substr(at, end - at);
    part.remove_prefix(std::min(part.find_first_not_of(' '), part.size()));
    at = end + 1;
    const std::size_t value = part.find(";dur=");
    if (value == std::string_view::npos || part.substr(0, value) != entry) continue;
    double milliseconds = 0;
    std::from_chars(part.data() + value + 5, part.data() + part.size(), milliseconds);
    return milliseconds;
  }
  return 0;
}

Result<Shot> shoot(Session& session, const Place& place, const Knobs& knobs) {
  const auto answer = draw(session, place, knobs, FrameFormat::exr);
  if (!answer) return answer.status();
  auto picture = decode_float_image(std::as_bytes(std::span(answer->body)), max_pixels);
  if (!picture) return picture.status();
  const auto drawn = decode_frame_request("{\"quality\": " + header(*answer, "pelage-quality") + "}");
  if (!drawn) return drawn.status();
  Shot shot{.picture = std::move(*picture), .scale = drawn->knobs.scale};
  measure(shot);
  return shot;
}

Result<FrameCost> cost_of_frame(Session& session, const Place& place, const Knobs& knobs, int repeats) {
  constexpr double never = std::numeric_limits<double>::infinity();
  FrameCost min{never, never};
  for (int i = 0; i < repeats; ++i) {
    Place moved = place;  // a little: a server does not draw again what it shows already
    moved.request.camera.position *= 1 + 1e-5 * (1 + i % 2);
    const auto answer = draw(session, moved, knobs, FrameFormat::png);
    if (!answer) return answer.status();
    const std::string timing = header(*answer, "server-timing");
    min.draw = std::min(min.draw, timing_of(timing, "draw") + timing_of(timing, "shadow"));
    min.cpu = std::min(min.cpu, timing_of(timing, "cpu"));
  }
  return min;
}

Result<PictureError> error_of(const FloatImage& truth, const FloatImage& picture) {
  return compare(truth, picture, union_of(alpha_mask(truth), alpha_mask(picture)));
}

std::string jpeg_of(const FloatImage& picture) {
  const FloatImage shown = as_displayed(picture, {.background = paper});
  Image image{shown.width, shown.height, std::vector<std::uint8_t>(shown.rgba.size(), 255)};
  for (std::size_t i = 0; i < shown.rgba.size(); ++i) {
    const double value = std::clamp(srgb_from_linear(double{shown.rgba[i]}), 0.0, 1.0);
    if (i % 4 != 3) image.rgba[i] = static_cast<std::uint8_t>(std::lround(255 * value));
  }
  return encode_jpeg(image, jpeg_quality);
}

}  // namespace pelage::trade

namespace pelage::trade {

namespace {

/// Of the default knobs, which have the estimate.
const std::string plain_name = "R1";

/// More samples of a pixel make another picture: finer strands are told apart before they are averaged.
double truth_scale(const Knobs& knobs) { return std::max(1.0, knobs.scale); }

std::string name_of_shells(const Knobs& knobs) {
  const std::string size =
      knobs.scale > 1 ? fmt::format("{} at {:g} times the size", plain_name, knobs.scale) : plain_name;
  if (knobs.shadow_maps) return fmt::format("{} with maps of {}", size, knobs.shadow_resolution);
  return knobs.self_shadow ? size : size + " without self-shadow";
}

/// The truth for these knobs: with their shadows, and their scale where it is above 1.
Knobs converged(int shells, const Knobs& wanted) {
  Knobs knobs;
  knobs.shells = shells;
  knobs.shell_policy = ShellPolicy::uniform;
  knobs.scale = truth_scale(wanted), knobs.guard_hairs = 0;
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
