// A long drawing in pieces: areas of about equal time, so that others may be served in between.
#pragma once

#include <functional>
#include <vector>

#include "renderer/passes/sorted/fragment_lists.h"

namespace pelage {

/// Asked between two pieces of a drawing. It may draw other frames with the same renderer meanwhile; false gives the
/// drawing up. The drawing's model has to be as it was when it answers true.
using Pause = std::function<bool()>;

/// Cuts an area into pieces while they are worked on: the time that one takes says how large the next may be.
class Pieces {
 public:
  static constexpr double target_ms = 60;

  /// `first_pixels`: at most so many in the first piece, above 0.
  Pieces(const Area& whole, double first_pixels) : open_{whole}, max_(first_pixels) {}

  bool done() const { return open_.empty(); }
  /// The next piece, where not done. Together the pieces hold each pixel of the whole once.
  Area next();
  /// How long the last piece took, milliseconds.
  void took(double milliseconds);

 private:
  std::vector<Area> open_;  // the next one last
  double max_;              // pixels of a piece
  double last_ = 0;         // pixels of the last piece
};

}  // namespace pelage
