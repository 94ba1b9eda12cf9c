// The groom in the formats of other programs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "protocol/commands/history.h"

namespace pelage {

/// `usda`: strands as BasisCurves of USD, as text. `hair`: strands as a HAIR file (cyHair). `shells`: the skin and
/// shells over it as a GLB that any viewer shows. `cards`: the skin and textured strips along the clumps of the fur in
/// levels of detail, as games draw it, as a GLB. `fields`: the skin with the fields of its fur as a GLB, for shaders.
/// `pelage`: the scene itself, with its model, log and pictures, for another server.
enum class ExportFormat { usda, hair, shells, cards, fields, pelage };

constexpr bool holds_strands(ExportFormat format) {
  return format == ExportFormat::usda || format == ExportFormat::hair;
}

/// The axes in which places are: those of the model's own file, or Pelage's, in which up is +y and front +z.
enum class AssetFrame { source, pelage };

/// How strands are drawn between their points: straight, or along Catmull-Rom's curves through them.
enum class CurveBasis { linear, cubic };

/// What of the fur is exported.
struct ExportRequest {
  ExportFormat format = ExportFormat::usda;
  std::string coat = {};                       // name of the only coat that is in it; "" for all that are not muted
  int every = 1;                               // about one strand in so many, chosen by a random number; [1, 1000000]
  bool widen = false;                          // makes strands `every` times as wide, which keeps what they cover
  bool curves = true;                          // with whiskers, lashes and brows
  CurveBasis basis = CurveBasis::linear;       // of `usda`
  bool skin = false;                           // `usda`: with the model's mesh
  int shells = 16;                             // number of shells over the skin, [1, 32]
  int cards = 6000;                            // of the finest level of `cards`, about; [100, 200000]
  AssetFrame frame = AssetFrame::source;       // of all formats but `pelage`
  std::optional<double> metres_per_unit = {};  // of the model's file, above 0; absent: 1
};

/// What a file holds, known before it is sent.
struct ExportAnswer {
  Revision revision = 0;
  ExportFormat format = ExportFormat::usda;
  std::uint64_t strands = 0, points = 0;
  std::uint64_t triangles = 0;
  std::uint64_t cards = 0;
  std::uint64_t bytes = 0;
  bool operator==(const ExportAnswer&) const = default;
};

}  // namespace pelage
