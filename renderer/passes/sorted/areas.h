// Areas of a picture that are worked on one after the other.
#pragma once

#include <vector>

namespace pelage {

/// Pixels, from the left and the top.
struct Area {
  int left = 0, top = 0, width = 0, height = 0;

  double pixels() const { return static_cast<double>(width) * height; }
  bool operator==(const Area&) const = default;
};

/// The two halves of an area of at least two pixels, cut across its longer side.
std::vector<Area> halves(const Area& area);

/// Cuts an area in halves until each has at most `most` pixels, or only one. Together they are the area.
std::vector<Area> cut(const Area& area, double most);

}  // namespace pelage
