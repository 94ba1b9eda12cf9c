// Strands as files of other programs.
#pragma once

#include <memory>
#include <vector>

#include "server/export/export_file.h"
#include "server/export/strands.h"

namespace pelage {

/// USD as text: an Xform at the model's centre, with the schema that Unreal takes as a groom, and linear BasisCurves in
/// the model's unit, Y up. Widths and colours (linear; displayColor, and groom_color as Unreal names it) for each
/// point; for each strand `st`, `groom_root_uv` (v up), `groom_id` and `groom_group_id` (0 fur, 1 curves);
/// `groom_guide` of all. A part for each array of each set, as text takes long to make.
std::vector<FilePart> usda_parts(const std::shared_ptr<const ExportedStrands>& strands, Revision revision,
                                 bool as_guides);

/// The HAIR format of cyHair (Yuksel): segments, points in model coordinates, thickness and linear colours.
/// Little endian, as its readers expect. False when the sink ended it.
bool write_hair(const ExportedStrands& strands, const Sink& sink);

}  // namespace pelage
