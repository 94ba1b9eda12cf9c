// The truths of a scene, drawn when they are first asked for.
#pragma once

#include <map>
#include <string>

#include "clients/cli/trade/shoot.h"

namespace pelage::trade {

/// A picture that others are measured against.
struct Truth {
  std::string name;  // "R1", "R1 maps" or "R2"
  Shot shot;
  double floor = 0;  // FLIP against half the layers; 0 for R2
};

class References {
 public:
  /// `shells` of R1; `passes` of R2.
  References(Session& session, Place place, int shells, int passes)
      : session_(session), place_(std::move(place)), shells_(shells), passes_(passes) {}

  /// R1 with the shadows that these knobs ask for: many uniform shells, fragments sorted, 32-bit float. Fur without
  /// self-shadow is measured against the estimate, for leaving shadow out is an error too. Its proof is the difference
  /// from half the shells; with maps that of the same fur without them, for layers do not differ by light.
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
