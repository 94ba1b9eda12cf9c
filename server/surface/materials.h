// The materials that a file gives its faces, by their names.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "server/surface/mesh.h"
#include "server/surface/weld.h"

namespace pelage {

/// Returns whether a material's name says that no fur grows there: an eye, a tooth, a claw, a beak, a hoof, a horn.
/// Words are told apart by capitals, digits and signs.
bool names_bare_part(std::string_view name);

/// Fills Mesh::materials and the report's: those that have a name, in the order of their first triangles, as many as
/// the limit allows. Materials of one name are one. Where all that is named is bare, nothing is.
void name_materials(const RawModel& raw, const Soup& soup, Mesh& mesh);

/// For each vertex whether all of its triangles have a material that is left bare, and has none of the names in
/// `known`.
std::vector<bool> bare_vertices(const Mesh& mesh, const std::vector<MaterialReport>& known = {});

}  // namespace pelage
