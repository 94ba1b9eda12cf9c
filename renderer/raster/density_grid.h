// How much fur stands in each cell of a grid around a model, and how much of it and of the body each light goes
// through on its way there: the shadows that fur and body cast on fur.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/raster/light_cells.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// A cube of some cells, by which changes are remembered.
struct GridBlock {
  glm::vec3 low{0}, high{0};
  bool fur = false;  // that stands or stood there has changed; else the skin there looks another way
};

/// What may be another in a block, bits of a flag.
enum BlockChange : std::int32_t { fur_changed = 1, light_changed = 2 };

/// Where blocks lie: block b is the cube from low + b side on.
struct BlockPlace {
  glm::vec3 low{0};
  float side = 1;  // sizes
  glm::ivec3 count{0};
};

/// Cells around the fur of all parts, which single curves have no part in.
GridPlace grid_place(std::span<const GrownPart> parts);

/// Returns how many of a part's first strands are summed to stand for all: about 8 on each cell face, where more stand
/// there. They suffice because any first part of the strands lies evenly.
std::uint32_t summed_strands(const GrownPart& part, float cell);

class DensityGrid {
 public:
  /// Brings the grid up to date: fur where parts have changed, light where fur or lights have. Curves cast no shadow:
  /// they are too thin for cells. Deterministic for any number of threads, and the same bits as of a new grid.
  void update(const FurModel& model, std::span<const GrownPart> parts, std::span<const FurLight> lights, int threads);

  const GridPlace& place() const { return place_; }
  /// Of each cell, without curves.
  std::span<const CellDensity> density() const { return density_; }
  /// Of each cell.
  std::span<const Crossed> crossed(std::size_t light) const { return lights_[light].crossed(); }
  std::size_t bytes() const;

  /// Counts updates; below, `since` is what it was at some time.
  std::uint64_t version() const { return version_; }
  /// Of the last update that changed fur.
  std::uint64_t fur_version() const { return fur_version_; }
  /// Of the last update that changed what a light crosses.
  std::uint64_t crossed_version() const { return crossed_version_; }
  /// Returns whether all may be another since then.
  bool all_changed(std::uint64_t since) const { return since < whole_version_; }
  BlockPlace blocks() const { return {place_.low, place_.cell * block_side, blocks_}; }
  /// Returns for each block, row by row, the bits of BlockChange for what may have changed in it, or around it as far
  /// as lookups read.
  std::vector<std::int32_t> changed_flags(std::uint64_t since) const;
  /// Returns whether that is so anywhere in a box.
  bool changed_in(glm::vec3 low, glm::vec3 high, std::uint64_t since) const;
  /// Returns the blocks whose skin may look different, or in which fur that has changed stands or stood.
  std::vector<GridBlock> changed_blocks(std::uint64_t since) const;

 private:
  static constexpr int block_side = 2;  // cells

  /// The parts of fur that are not as they are held.
  std::vector<std::uint32_t> other_parts(std::span<const GrownPart> parts) const;
  void clear_fur();
  /// The cells in which anything may have changed.
  CellRows add_fur(std::span<const GrownPart> parts, int threads);
  void mark_fur(std::span<const glm::ivec3> cells, CellRows& rows);
  void mark_skin(const GrownPart& part);
  void mark_light(std::span<const std::uint32_t> cells);
  void find_skin(const FurModel& model);
  void make_anew(const GridPlace& place, std::size_t parts);
  void follow_lights(const FurModel& model, std::span<const FurLight> lights, const CellRows& changed, int threads);
  glm::ivec3 block_of(glm::vec3 place) const;
  /// use(block) from first to last.
  template <class Use>
  static void each_block(glm::ivec3 first, glm::ivec3 last, const Use& use);
  std::size_t block_at(glm::ivec3 block) const {
    return static_cast<std::size_t>((block.z * blocks_.y + block.y) * blocks_.x + block.x);
  }

  GridPlace place_;
  std::vector<CellDensity> density_;
  std::vector<GrownPart> held_;  // what is in it of each part; no strands for nothing
  std::uint64_t model_ = 0;
  std::vector<LightCells> lights_;
  std::uint64_t version_ = 0, fur_version_ = 0, crossed_version_ = 0, whole_version_ = 0;
  glm::ivec3 blocks_{0};
  // Of each block: the version that changed anything that is read there, that changed its fur, and whether it has skin.
  std::vector<std::uint64_t> of_block_, fur_of_block_;
  std::vector<std::uint8_t> has_skin_;
};

}  // namespace pelage
