// Guide curves of other programs, as an upload.
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

/// What comes with the bytes of guide curves. Each becomes a key of an `interpolate`: where its root stands, where its
/// tip leans to, and its length.
struct GuideUpload {
  GuideFormat format = GuideFormat::usda;
  std::string coat = {};                 // that follows them; "" for all
  int keys = 1024;                       // at most, chosen evenly; [1, 1024]
  std::optional<double> sigma = {};      // of the Interpolate, sizes, above 0; absent: from the distance between roots
  double strength = 1;                   // [0, 1]
  std::optional<AssetFrame> frame = {};  // of the file's places; absent: source of usda and hair, pelage of json
  std::optional<double> metres_per_unit =
      {};  // of the model's file, above 0; absent: what its format says, if anything
};

/// What a file of guide curves holds.
struct GuideFile {
  std::vector<GuideCurve> curves;     // in the file's coordinates, each of at least two points, root first
  std::optional<Axis> up = {};        // +y or +z, where the file says it
  std::optional<double> metres = {};  // that its unit is, above 0, where the file says it
  std::uint64_t single = 0;           // curves of one point or none, which are left out
};

}  // namespace pelage
