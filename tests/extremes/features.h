// The features that a scene may have or not: how it is put into a scene, and what names it without using it.
#pragma once

#include <string>
#include <vector>

namespace pelage::testing {

/// Texts as a client sends them: commands in one batch ("" for none), and members of a frame's quality.
struct Feature {
  std::string name;
  std::string commands, frame = "";            // with the feature
  std::string rest_commands, rest_frame = "";  // the same named, at rest
};

std::vector<Feature> features();

}  // namespace pelage::testing
