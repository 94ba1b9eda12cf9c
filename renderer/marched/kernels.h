// What is compiled for several instruction sets, of which the machine's best is chosen when the program runs.
#pragma once

#include <cstddef>

#include "renderer/marched/crossings.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

/// Fills the vertices [begin, end) of all shells.
void place_shell_vertices(MarchScene& scene, std::size_t begin, std::size_t end);

/// Draws a tile: premultiplied linear light into `light`, four numbers a pixel, rows from the top, of the whole
/// picture.
void draw_tile(const MarchScene& scene, const Tile& tile, TileScratch& scratch, float* light);

/// The instruction set in use, as "AVX2".
const char* instruction_set();

}  // namespace pelage
