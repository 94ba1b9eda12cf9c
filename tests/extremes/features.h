// Features that a scene may have: what puts each into a scene, and what names it without using it.
#pragma once

#include <string>
#include <vector>

namespace pelage::testing {

/// JSON as a client sends it: commands in one batch ("" for none), and members of a frame's quality.
struct Feature {
  std::string name;
  std::string commands, frame = "";            // use the feature
  std::string rest_commands, rest_frame = "";  // name the feature but leave it unused
};

/// What each coat of these has: a tile of more strands only takes longer to bake.
inline const std::string few_strands = R"("count": 500)";

std::vector<Feature> features();

}  // namespace pelage::testing
