// The named materials of a file's faces, and which of them stay without fur.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "server/surface/mesh.h"
#include "server/surface/weld.h"

namespace pelage {

/// Returns whether a material's name says that no fur grows there: an eye, a tooth, a claw, a beak, a hoof, a horn. A
/// name is split into words at capitals, digits and punctuation.
bool names_bare_part(std::string_view name);

/// Fills Mesh::materials and the materials of its report with those that have a name, in the order of their first
/// triangles, up to the limit. Materials of the same name are merged. If the whole mesh would be bare, nothing is.
void name_materials(const RawModel& raw, const Soup& soup, Mesh& mesh);

/// Returns for each vertex whether all of its triangles have bare materials whose names are not in `known`.
std::vector<bool> bare_vertices(const Mesh& mesh, const std::vector<MaterialReport>& known = {});

}  // namespace pelage
