// Uploads of guide curves from other programs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/commands/creature.h"
#include "protocol/commands/export.h"

namespace pelage {

/// usda: BasisCurves of USD as text. hair: HAIR (cyHair). json: {"curves": [[[x, y, z], ...], ...]}.
enum class GuideFormat { usda, hair, json };

/// The parameters of an upload of guide curves. Each curve becomes a key of an `interpolate`: the position of its root,
/// the direction and inclination of its tip, and its length.
struct GuideUpload {
  GuideFormat format = GuideFormat::usda;
  std::string coat = {};                 // name of the coat that follows them; "" for all
  int keys = 1024;                       // largest number of keys, chosen evenly, [1, 1024]
  std::optional<double> sigma = {};      // Interpolate::sigma, sizes, above 0; absent: from the distance between roots
  double strength = 1;                   // [0, 1]
  std::optional<AssetFrame> frame = {};  // axes of the file; absent: source for usda and hair, pelage for json
  std::optional<double> metres_per_unit = {};  // metres per unit of the model's file, above 0; absent: what it says
};

/// The contents of a file of guide curves.
struct GuideFile {
  std::vector<GuideCurve> curves;     // in the file's coordinates, each of at least two points, root first
  std::optional<Axis> up = {};        // +y or +z; absent if the file does not say
  std::optional<double> metres = {};  // metres per unit of the file, above 0; absent if it does not say
  std::uint64_t single = 0;           // number of curves left out because they have fewer than two points
};

}  // namespace pelage
