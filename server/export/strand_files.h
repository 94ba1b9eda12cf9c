// Writes strands to files of other programs.
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

/// Writes USD as text: an Xform at the model's centre with the schema that Unreal imports as a groom, BasisCurves in
/// the model's unit and in the axes of the strands' transform, and the skin as a Mesh if there is one. Each point has a
/// width and a linear colour, under USD's names and as groom_width and groom_color. Each strand has `st` and
/// `groom_root_uv` (v up), `groom_id`, and `groom_group_id` (see StrandGroup) with its name; `groom_guide` is one for
/// all. Cubic curves are Catmull-Rom curves through the same points. Returns a part for each array of each set, since
/// text is slow to make.
std::vector<FilePart> usda_parts(const std::shared_ptr<const ExportedStrands>& strands, const UsdaForm& form);

/// Writes the HAIR format of cyHair (Yuksel): segments, points in the axes of the strands' transform, thickness and
/// linear colours; little endian, as its readers expect. Returns false if the sink has ended the writing.
bool write_hair(const ExportedStrands& strands, const Sink& sink);

}  // namespace pelage
