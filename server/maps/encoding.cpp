#include "server/maps/encoding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/colour_space.h"

namespace pelage {

namespace {

MapLayout value_layout(Field field, double scale, bool floats) {
  const FieldShape& shape = shape_of(field);
  MapLayout layout;
  layout.channels = shape.channels;
  if (shape.channels == 4) {
    layout.kinds = {ChannelKind::colour, ChannelKind::colour, ChannelKind::colour, ChannelKind::share};
    layout.premultiplied = true;
    return layout;
  }
  layout.background = glm::dvec4(double{shape.default_value} / scale);
  layout.max = glm::dvec4(floats ? double{shape.max} / scale : 1.0);
  return layout;
}

MapLayout fast_fur_layout(double scale, bool floats) {
  MapLayout layout;
  layout.channels = 4;
  layout.kinds = {ChannelKind::part, ChannelKind::part, ChannelKind::share, ChannelKind::share};
  layout.min = {-1, -1, 0, 0};
  layout.max.z = floats ? double{shape_of(Field::width).max} / scale : 1.0;
  layout.background = {0, 0, double{shape_of(Field::width).default_value} / scale,
                       double{shape_of(Field::density).default_value}};
  return layout;
}

}  // namespace

MapLayout layout_of(Field field, MapEncoding encoding, double scale, bool floats) {
  assert(fits(field, encoding));
  if (encoding == MapEncoding::value) return value_layout(field, scale, floats);
  if (encoding == MapEncoding::fast_fur) return fast_fur_layout(scale, floats);
  MapLayout layout;
  if (encoding == MapEncoding::vector) {
    constexpr double boundless = std::numeric_limits<double>::infinity();
    layout.channels = 3;
    layout.kinds.fill(ChannelKind::as_it_is);
    layout.min = glm::dvec4(-boundless), layout.max = glm::dvec4(boundless);
    return layout;
  }
  layout.channels = 2;
  layout.kinds.fill(ChannelKind::part);
  layout.min = glm::dvec4(-1);
  return layout;
}

double file_number(ChannelKind kind, double value, int bits) {
  if (bits == 32) return kind == ChannelKind::part ? 0.5 + 0.5 * value : value;
  const double max = bits == 8 ? 255 : 65535, middle = (max + 1) / 2;
  if (kind == ChannelKind::part) return middle + std::round((middle - 1) * std::clamp(value, -1.0, 1.0));
  const double held = std::clamp(value, 0.0, 1.0);
  return std::round(max * (kind == ChannelKind::colour ? srgb_from_linear(held) : held));
}

double value_of(ChannelKind kind, double number, int bits) {
  if (bits == 32) return kind == ChannelKind::part ? 2 * number - 1 : number;
  if (kind == ChannelKind::colour) return linear_from_srgb(number);
  if (kind != ChannelKind::part) return number;
  const double max = bits == 8 ? 255 : 65535, middle = (max + 1) / 2;
  return std::max((std::round(number * max) - middle) / (middle - 1), -1.0);
}

}  // namespace pelage
