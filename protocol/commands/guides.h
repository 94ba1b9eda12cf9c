// Guide curves of other programs, as an upload.
#pragma once

#include <optional>

namespace pelage {

/// usda: BasisCurves of USD as text. hair: HAIR (cyHair). json: {"curves": [[[x, y, z], ...], ...]}.
enum class GuideFormat { usda, hair, json };

/// What comes with the bytes of guide curves. Each becomes a key of an `interpolate`: where its root stands, where its
/// tip leans to, and its length.
struct GuideUpload {
  GuideFormat format = GuideFormat::usda;
  int keys = 1024;                   // at most, chosen evenly; [1, 1024]
  std::optional<double> sigma = {};  // of the Interpolate, sizes, above 0; absent: from the distance between roots
  double strength = 1;               // [0, 1]
};

}  // namespace pelage
