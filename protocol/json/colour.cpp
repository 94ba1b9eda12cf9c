#include "protocol/json/colour.h"

#include <algorithm>
#include <cmath>

#include "base/colour_space.h"

namespace pelage {

namespace {

/// Converts a level of 0 to 255 from sRGB (IEC 61966-2-1).
float linear_of_srgb(int level) { return static_cast<float>(linear_from_srgb(level / 255.0)); }

int srgb_of_linear(float linear) {
  return static_cast<int>(std::lround(255 * std::clamp(srgb_from_linear(double{linear}), 0.0, 1.0)));
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

std::optional<glm::vec3> colour_of_text(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return {};
  glm::vec3 colour(0);
  for (int k = 0; k < 3; ++k) {
    const int high = hex_digit(text[static_cast<std::size_t>(1 + 2 * k)]);
    const int low = hex_digit(text[static_cast<std::size_t>(2 + 2 * k)]);
    if (high < 0 || low < 0) return {};
    colour[k] = linear_of_srgb(16 * high + low);
  }
  return colour;
}

std::optional<std::string> text_of_colour(glm::vec3 linear) {
  static constexpr char digits[] = "0123456789abcdef";
  std::string text = "#";
  for (int k = 0; k < 3; ++k) {
    const int level = srgb_of_linear(linear[k]);
    text += digits[level / 16];
    text += digits[level % 16];
  }
  const auto decoded = colour_of_text(text);
  // -0 is equal to 0 but has no #rrggbb, so the sign is checked as well.
  const bool exact =
      decoded && *decoded == linear && !std::signbit(linear.x) && !std::signbit(linear.y) && !std::signbit(linear.z);
  return exact ? std::optional(text) : std::nullopt;
}

}  // namespace pelage
