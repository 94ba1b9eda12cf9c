#include "clients/cli/trade/shoot.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>

#include "protocol/json/decode.h"
#include "protocol/json/encode.h"
#include "renderer/image/image.h"

namespace pelage::trade {

namespace {

constexpr std::size_t most_pixels = std::size_t{1} << 26;
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
    sum += 0.2126 * double{p[0]} + 0.7152 * double{p[1]} + 0.0722 * double{p[2]};  // Rec. 709
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
  auto picture = decode_float_image(std::as_bytes(std::span(answer->body)), most_pixels);
  if (!picture) return picture.status();
  const auto drawn = decode_frame_request("{\"quality\": " + header(*answer, "pelage-quality") + "}");
  if (!drawn) return drawn.status();
  Shot shot{.picture = std::move(*picture), .scale = drawn->knobs.scale};
  measure(shot);
  return shot;
}

Result<FrameCost> cost_of_frame(Session& session, const Place& place, const Knobs& knobs, int repeats) {
  constexpr double never = std::numeric_limits<double>::infinity();
  FrameCost least{never, never};
  for (int i = 0; i < repeats; ++i) {
    Place moved = place;  // a little: a server does not draw again what it shows already
    moved.request.camera.eye *= 1 + 1e-5 * (1 + i % 2);
    const auto answer = draw(session, moved, knobs, FrameFormat::png);
    if (!answer) return answer.status();
    const std::string timing = header(*answer, "server-timing");
    least.draw = std::min(least.draw, timing_of(timing, "draw") + timing_of(timing, "shadow"));
    least.cpu = std::min(least.cpu, timing_of(timing, "cost"));
  }
  return least;
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
