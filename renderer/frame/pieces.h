// A long drawing in pieces: areas of about equal time, so that others may be served in between.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "protocol/base/status.h"
#include "renderer/passes/sorted/sorted_pass.h"

namespace pelage {

/// Asked between two pieces of a drawing. It may draw other frames with the same renderer meanwhile; false gives the
/// drawing up. The drawing's model has to be as it was when it answers true.
using Pause = std::function<bool()>;

inline Status drawing_given_up() { return failure(Code::conflict, "the drawing was given up"); }
inline Status no_memory_for_frame() { return failure(Code::too_large, "no memory for a frame of this size", "/width"); }

/// Cuts an area into pieces while they are worked on, so that each takes about as long. What a piece takes is estimated
/// from its work and the time of a unit of work, as the slowest pieces lately took it.
class Pieces {
 public:
  static constexpr double target_ms = 100;
  static constexpr double min_pixels = 8 * 8;  // below it a piece costs its triangles, not its pixels
  /// Units of work, estimated, in an area; those of its parts sum to it.
  using Work = std::function<double(const Area&)>;

  /// `unit_ms`: time of a unit of work until one was measured, above 0.
  Pieces(const Area& whole, Work work, double unit_ms) : open_{whole}, work_(std::move(work)), unit_ms_(unit_ms) {}

  bool done() const { return open_.empty(); }
  /// The next piece, where not done. Together the pieces hold each pixel of the whole once.
  Area next();
  /// How long the last piece took.
  void took(double milliseconds);

 private:
  std::vector<Area> open_;  // the next one last
  Work work_;
  double unit_ms_;
  double last_ = 0;  // work of the last piece
};

}  // namespace pelage
