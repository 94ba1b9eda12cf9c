#include "renderer/coat/side_view.h"

#include <algorithm>
#include <cmath>

#include "renderer/coat/strand_tile.h"

namespace pelage {

namespace {

/// A row's stretch across one strand.
struct Span {
  double middle;  // texels
  double radius;  // texels
  glm::vec3 colour;
};

void draw(const Span& span, glm::vec4* row) {
  const double reach = std::max(span.radius, 0.5), share = span.radius / reach;
  const int low = static_cast<int>(std::floor(span.middle - reach - 0.5));
  const int high = static_cast<int>(std::ceil(span.middle + reach + 0.5));
  for (int x = low; x <= high; ++x) {
    const double inside = std::clamp(reach + 0.5 - std::abs(x + 0.5 - span.middle), 0.0, 1.0);
    const auto opacity = static_cast<float>(std::min(0.997, share * inside));
    glm::vec4& texel = row[x & (side_view_width - 1)];
    texel = texel * (1 - opacity) + glm::vec4(span.colour * opacity, opacity);
  }
}

void draw(const Coat& coat, const Strand& strand, std::vector<glm::vec4>& picture) {
  const double to_texels = side_view_width / coat.tile;
  for (int y = 0; y < side_view_height; ++y) {
    const double s = (y + 0.5) / side_view_height, left = strand.length_share - s;
    if (left <= 0) break;
    const double q = std::min(1.0, s / strand.length_share);
    const double ending = std::min(1.0, left * side_view_height);  // a tip ends inside its row
    const double radius = 0.5 * strand.width * glm::mix(coat.width_root, coat.width_tip, q) * ending * to_texels;
    draw({(strand.root.x + strand_offset(coat, strand, q).x) * to_texels,
          std::min(radius, 0.5 * side_view_width + 1),  // then it covers the whole row
          strand_colour(coat, strand, q)},
         &picture[static_cast<std::size_t>(y) * side_view_width]);
  }
}

}  // namespace

std::vector<glm::vec4> bake_side_view(const Coat& coat) {
  std::vector<Strand> strands = make_strands(coat);
  std::erase_if(strands, [&](const Strand& strand) { return strand.root.y >= side_view_depth * coat.tile; });
  std::stable_sort(strands.begin(), strands.end(),
                   [](const Strand& a, const Strand& b) { return a.root.y > b.root.y; });
  std::vector<glm::vec4> picture(side_view_width * side_view_height, glm::vec4(0));
  for (const Strand& strand : strands) draw(coat, strand, picture);
  return picture;
}

}  // namespace pelage
