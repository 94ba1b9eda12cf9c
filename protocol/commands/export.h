// Exports of a groom in the formats of other programs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "protocol/commands/history.h"

namespace pelage {

/// usda: strands as BasisCurves of USD, as text. hair: strands as a HAIR file (cyHair). shells: the skin and shells
/// over it as a GLB for any viewer. cards: the skin and textured strips along the clumps of the fur, in levels of
/// detail as games draw them, as a GLB. fields: the skin with the fields of its fur as a GLB, for shaders. pelage: the
/// scene itself, with its model, log and pictures, for another server.
enum class ExportFormat { usda, hair, shells, cards, fields, pelage };

constexpr bool holds_strands(ExportFormat format) {
  return format == ExportFormat::usda || format == ExportFormat::hair;
}

/// The axes of positions in a file: those of the model's own file, or Pelage's, in which up is +y and front +z.
enum class AssetFrame { source, pelage };

/// How strands run between their points: straight, or along Catmull-Rom curves through them.
enum class CurveBasis { linear, cubic };

/// What is exported, and how.
struct ExportRequest {
  ExportFormat format = ExportFormat::usda;
  std::string coat = {};                       // name of the only coat to export; "" for all that are not muted
  int every = 1;                               // exports about one strand in `every`, chosen at random; [1, 1000000]
  bool widen = false;                          // makes strands `every` times as wide, to keep their coverage
  bool curves = true;                          // includes whiskers, lashes and brows
  CurveBasis basis = CurveBasis::linear;       // `usda` only
  bool skin = false;                           // `usda` only: includes the model's mesh
  int shells = 16;                             // number of shells over the skin, [1, 32]
  int cards = 6000;                            // about how many cards the finest level has, [100, 200000]
  AssetFrame frame = AssetFrame::source;       // for all formats except `pelage`
  std::optional<double> metres_per_unit = {};  // metres per unit of the model's file, above 0; absent: 1
};

/// The contents of an exported file, known before it is sent.
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
