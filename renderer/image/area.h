// A rectangle of a picture.
#pragma once

namespace pelage {

/// A rectangle in pixels, from the left and the top.
struct Area {
  int left = 0, top = 0, width = 0, height = 0;

  double pixels() const { return static_cast<double>(width) * height; }
  bool operator==(const Area&) const = default;
};

}  // namespace pelage
