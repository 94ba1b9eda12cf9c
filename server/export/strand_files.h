// Strands as files of other programs.
#pragma once

#include <memory>
#include <vector>

#include "server/export/export_file.h"
#include "server/export/strands.h"

namespace pelage {

struct UsdaForm {
  Revision revision = 0;
  bool as_guides = false;
  CurveBasis basis = CurveBasis::linear;
};

/// USD as text: an Xform at the model's centre, with the schema that Unreal takes as a groom, BasisCurves in the
/// model's unit and the axes of the strands' place, and the skin as a Mesh where there is one. Widths and colours
/// (linear) for each point, as USD names them and as groom_width and groom_color; for each strand `st`, `groom_root_uv`
/// (v up), `groom_id`, and `groom_group_id` (0 fur, 1 curves) with its name; `groom_guide` of all. Cubic curves are
/// Catmull-Rom's through the same points. A part for each array of each set, as text takes long to make.
std::vector<FilePart> usda_parts(const std::shared_ptr<const ExportedStrands>& strands, const UsdaForm& form);

/// The HAIR format of cyHair (Yuksel): segments, points in the axes of the strands' place, thickness and linear
/// colours. Little endian, as its readers expect. False when the sink ended it.
bool write_hair(const ExportedStrands& strands, const Sink& sink);

}  // namespace pelage
