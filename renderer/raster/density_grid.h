// A grid around a model with the density of fur in each cell, and how much fur and body each light crosses on its way
// to each cell: the shadows that fur and body cast on fur.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/raster/light_cells.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// A cube of a few cells; changes are recorded for each block.
struct GridBlock {
  glm::vec3 low{0}, high{0};
  bool fur = false;  // fur in the block has changed or gone; false: only the look of the skin there may have changed
};

/// What may have changed in a block, as bits of a flag.
enum BlockChange : std::int32_t { fur_changed = 1, light_changed = 2 };

/// Layout of the blocks: block b is the cube with its lowest corner at low + b side.
struct BlockLayout {
  glm::vec3 low{0};
  float side = 1;       // sizes
  glm::ivec3 count{0};  // blocks along each axis
};

/// Returns the grid around the fur of all coats. Curves do not count.
GridLayout grid_layout(std::span<const GrownPart> parts);

/// Returns how many of a part's first strands are summed on behalf of all: about 8 for each cell face if more stand
/// there. They suffice because the first n strands of a part lie evenly over its skin, for any n.
std::uint32_t summed_strands(const GrownPart& part, float cell);

class DensityGrid {
 public:
  /// Updates the density where parts have changed, and the light where fur or lights have. Curves cast no shadow: they
  /// are too thin for cells. Deterministic for any number of threads, with the same bits as in a new grid.
  void update(const FurModel& model, std::span<const GrownPart> parts, std::span<const FurLight> lights, int threads);

  const GridLayout& layout() const { return layout_; }
  /// Returns the density of each cell, without curves.
  std::span<const CellDensity> density() const { return density_; }
  /// Returns what a light crosses on its way to each cell.
  std::span<const Crossed> crossed(std::size_t light) const { return lights_[light].crossed(); }
  std::size_t bytes() const;

  /// Returns the number of updates so far. `since` below is an earlier value of it.
  std::uint64_t version() const { return version_; }
  /// Returns the version of the last update that changed fur.
  std::uint64_t fur_version() const { return fur_version_; }
  /// Returns the version of the last update that changed what a light crosses.
  std::uint64_t crossed_version() const { return crossed_version_; }
  /// Returns whether everything may have changed since then.
  bool all_changed(std::uint64_t since) const { return since < rebuilt_version_; }
  BlockLayout blocks() const { return {layout_.low, layout_.cell * block_side, blocks_}; }
  /// Returns for each block, row by row, the BlockChange bits of what may have changed in it or within reach of its
  /// lookups.
  std::vector<std::int32_t> changed_flags(std::uint64_t since) const;
  /// Returns whether any block that touches the box may have changed.
  bool changed_in(glm::vec3 low, glm::vec3 high, std::uint64_t since) const;
  /// Returns the blocks whose skin may look different, and those with fur that has changed, before or after the change.
  std::vector<GridBlock> changed_blocks(std::uint64_t since) const;

 private:
  static constexpr int block_side = 2;  // cells

  /// Returns the parts of coats whose strands differ from those in held_.
  std::vector<std::uint32_t> changed_parts(std::span<const GrownPart> parts) const;
  void clear_fur();
  /// Returns the cells in which the density may have changed.
  CellRows add_fur(std::span<const GrownPart> parts, int threads);
  void mark_fur(std::span<const glm::ivec3> cells, CellRows& rows);
  void mark_skin(const GrownPart& part);
  void mark_light(std::span<const std::uint32_t> cells);
  void find_skin(const FurModel& model);
  void reset(const GridLayout& layout, std::size_t parts);
  void update_lights(const FurModel& model, std::span<const FurLight> lights, const CellRows& changed, int threads);
  glm::ivec3 block_of(glm::vec3 position) const;
  /// Calls use(block) for each block from `first` to `last`, both included.
  template <class Use>
  static void each_block(glm::ivec3 first, glm::ivec3 last, const Use& use);
  std::size_t block_at(glm::ivec3 block) const {
    return static_cast<std::size_t>((block.z * blocks_.y + block.y) * blocks_.x + block.x);
  }

  GridLayout layout_;
  std::vector<CellDensity> density_;
  std::vector<GrownPart> summed_parts_;  // each part as it is summed in density_; without strands if it is not
  std::uint64_t model_ = 0;
  std::vector<LightCells> lights_;
  std::uint64_t version_ = 0, fur_version_ = 0, crossed_version_ = 0, rebuilt_version_ = 0;
  glm::ivec3 blocks_{0};
  // For each block: the last version that changed anything lookups read there, the last that changed its fur, and
  // whether it contains skin.
  std::vector<std::uint64_t> of_block_, fur_of_block_;
  std::vector<std::uint8_t> has_skin_;
};

}  // namespace pelage
