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
    layout.kinds = {ChannelKind::colour, ChannelKind::colour, ChannelKind::colour, ChannelKind::unit};
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
  layout.kinds = {ChannelKind::signed_unit, ChannelKind::signed_unit, ChannelKind::unit, ChannelKind::unit};
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
    layout.kinds.fill(ChannelKind::raw);
    layout.min = glm::dvec4(-boundless), layout.max = glm::dvec4(boundless);
    return layout;
  }
  layout.channels = 2;
  layout.kinds.fill(ChannelKind::signed_unit);
  layout.min = glm::dvec4(-1);
  return layout;
}

double encode_channel(ChannelKind kind, double value, int bits) {
  if (bits == 32) return kind == ChannelKind::signed_unit ? 0.5 + 0.5 * value : value;
  const double max = bits == 8 ? 255 : 65535, middle = (max + 1) / 2;
  if (kind == ChannelKind::signed_unit) return middle + std::round((middle - 1) * std::clamp(value, -1.0, 1.0));
  const double clamped = std::clamp(value, 0.0, 1.0);
  return std::round(max * (kind == ChannelKind::colour ? srgb_from_linear(clamped) : clamped));
}

double decode_channel(ChannelKind kind, double number, int bits) {
  if (bits == 32) return kind == ChannelKind::signed_unit ? 2 * number - 1 : number;
  if (kind == ChannelKind::colour) return linear_from_srgb(number);
  if (kind != ChannelKind::signed_unit) return number;
  const double max = bits == 8 ? 255 : 65535, middle = (max + 1) / 2;
  return std::max((std::round(number * max) - middle) / (middle - 1), -1.0);
}

}  // namespace pelage
