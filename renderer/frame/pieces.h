// A long drawing in pieces: areas of about equal time, so that others may be served in between.
#pragma once

#include <functional>
#include <vector>

#include "renderer/passes/sorted/fragment_lists.h"

namespace pelage {

/// Asked between two pieces of a drawing. It may draw other frames with the same renderer meanwhile; false gives the
/// drawing up. The drawing's model has to be as it was when it answers true.
using Pause = std::function<bool()>;

/// Cuts an area into pieces while they are worked on. How long a piece takes is foreseen from its pixels, the
/// fragments that a pixel of fur had lately, and the time of a fragment: an empty piece says nothing about the next.
class Pieces {
 public:
  static constexpr double target_ms = 150;

  /// `fragments`: expected in a pixel full of fur, above 0; `fragment_ms`: time of one, until one was measured.
  Pieces(const Area& whole, double fragments, double fragment_ms)
      : open_{whole}, fragments_(fragments), max_(target_ms / (fragments * fragment_ms)) {}

  bool done() const { return open_.empty(); }
  /// The next piece, where not done. Together the pieces hold each pixel of the whole once.
  Area next();
  /// How long the last piece took, milliseconds, and how many fragments it drew.
  void took(double milliseconds, double fragments);

 private:
  std::vector<Area> open_;  // the next one last
  double fragments_;        // of a pixel of fur
  double max_;              // pixels of a piece
  double last_ = 0;         // pixels of the last piece
};

}  // namespace pelage
