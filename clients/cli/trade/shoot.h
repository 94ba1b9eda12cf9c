// Frames over HTTP, what they cost, and how far they are from each other.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "clients/cli/session.h"
#include "protocol/commands/frame.h"
#include "renderer/compare/compare.h"

namespace pelage::trade {

/// Where frames are drawn, and from where they are seen.
struct Place {
  std::string scene_path;  // "/v1/scenes/ID"
  FrameRequest request;    // knobs and format are not looked at
};

/// A picture in linear light, and figures of it.
struct Shot {
  FloatImage picture;
  double scale = 1;                    // as drawn: the knob, after `min_radius`
  std::size_t non_finite = 0;          // pixels
  double luminance = 0, coverage = 0;  // mean over alpha; sum of alpha in pixels
};

/// Milliseconds of drawing, shadows included.
struct FrameCost {
  double draw = 0;
  double cpu = 0;  // of all threads; 0 where the server does not say
};

/// The milliseconds of one entry of a Server-Timing header; 0 where it is not there.
double timing_of(std::string_view header, std::string_view entry);

Result<Shot> shoot(Session& session, const Place& place, const Knobs& knobs);

/// The least of so many frames, each measure by itself.
Result<FrameCost> cost_of_frame(Session& session, const Place& place, const Knobs& knobs, int repeats);

/// Over the fur of both, as they are shown.
Result<PictureError> error_of(const FloatImage& truth, const FloatImage& picture);

/// A JPEG of a picture as it is shown over grey.
std::string jpeg_of(const FloatImage& picture);

}  // namespace pelage::trade

// The truths of a scene, drawn when they are first asked for.

namespace pelage::trade {

/// A picture that others are measured against.
struct Truth {
  std::string name;  // "R1", with its shadows where they are not the estimate, or "R2"
  Shot shot;
  int detail = 0;    // shells of R1, or passes of R2
  double floor = 0;  // FLIP against half the shells; 0 for R2
};

class References {
 public:
  /// `shells` of R1; `passes` of R2.
  References(Session& session, Place place, int shells, int passes)
      : session_(session), place_(std::move(place)), shells_(shells), passes_(passes) {}

  /// R1 with the shadows of these knobs: many uniform shells, fragments sorted, 32-bit float. Shadows are the same so
  /// that shells are measured and not light; what light leaves out is seen against R2. Its proof is the difference from
  /// half the shells under the estimate of self-shadow, for the shells are the same in any light.
  Result<const Truth*> shells(const Knobs& knobs);

  /// R2: traced strands, lit by the look's own model.
  Result<const Truth*> strands();

 private:
  Result<Truth> draw(const std::string& name, const Knobs& knobs);
  Result<const Truth*> keep(Truth truth);

  Session& session_;
  Place place_;
  int shells_, passes_;
  std::map<std::string, Truth> drawn_;
};

}  // namespace pelage::trade
