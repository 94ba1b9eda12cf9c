// What the eyes of a frame are made of, as plain numbers: the uniform block and the textures of the GPU's eyes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/eye/eye_block.h"
#include "renderer/eye/iris_map.h"

namespace pelage {

/// The tissue of an iris and a sclera (make_iris_map) with its mip levels, four bytes a word.
struct TissueLevels {
  static constexpr int count = 9;  // down to one row
  std::vector<std::int32_t> words;
  std::array<std::int32_t, count> first{};  // word of each level
};
static_assert(iris_map_height >> (TissueLevels::count - 1) == 1);

/// Views that outlive the frame's drawing.
struct EyeOptics {
  EyeBlock block;
  int steps = 0;                          // into the iris: Knobs::eye_steps
  const TissueLevels* tissues = nullptr;  // not null where there are eyes
  std::span<const float> caustics;        // gather_caustics of each shape, one after the other
};

}  // namespace pelage
