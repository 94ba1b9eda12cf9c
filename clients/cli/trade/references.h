// The truths of a scene, drawn when they are first asked for.
#pragma once

#include <map>
#include <string>

#include "clients/cli/trade/shoot.h"

namespace pelage::trade {

/// A picture that others are measured against.
struct Truth {
  std::string name;  // "R1", with its shadows where they are not the estimate, or "R2"
  Shot shot;
  int detail = 0;    // shells of R1, or passes of R2
  double floor = 0;  // FLIP against half the layers; 0 for R2
};

class References {
 public:
  /// `shells` of R1; `passes` of R2.
  References(Session& session, Place place, int shells, int passes)
      : session_(session), place_(std::move(place)), shells_(shells), passes_(passes) {}

  /// R1 with the shadows of these knobs: many uniform shells, fragments sorted, 32-bit float. Shadows are the same so
  /// that layers are measured and not light; what light leaves out is seen against R2. Its proof is the difference from
  /// half the shells under the estimate of self-shadow, for the layers are the same in any light.
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
