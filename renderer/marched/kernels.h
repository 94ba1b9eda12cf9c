// What is compiled for several instruction sets, of which the machine's best is chosen when the program runs.
#pragma once

#include <cstddef>

#include "renderer/marched/crossings.h"
#include "renderer/marched/march_scene.h"

namespace pelage {

/// Fills the vertices [begin, end) of all shells.
void place_shell_vertices(MarchScene& scene, std::size_t begin, std::size_t end);

/// Draws a tile: premultiplied linear light into `light`, four numbers a pixel, rows from the top, of the whole
/// picture, and what AOVs keep into `aovs` where that is not null.
void draw_tile(const MarchScene& scene, const Tile& tile, TileScratch& scratch, float* light, AovPixel* aovs);

/// Of a light's view, in the shells of shadow_shell_set: the share of light that comes to each boundary, into maps of
/// the whole picture, one after the other (ShellShadow::kept).
void draw_shell_shadow(const MarchScene& scene, const Tile& tile, TileScratch& scratch, float* maps);

/// The instruction set in use, as "AVX2".
const char* instruction_set();

}  // namespace pelage
