// How much fur stands in each cell of a grid around a model, and how much of it and of the body each light goes
// through on its way there: the shadows that fur and body cast on fur.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "renderer/input/fur_scene.h"
#include "renderer/strands/grown_fur.h"

namespace pelage {

/// Where cells lie: cell c is the cube about low + (c + .5) cell.
struct GridPlace {
  glm::vec3 low{0};
  float cell = 1;       // sizes
  glm::ivec3 size{2};   // cells along each axis, at least 2

  std::size_t count() const {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
  }
  std::size_t index(glm::ivec3 c) const {
    return (static_cast<std::size_t>(c.z) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(c.y)) *
               static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(c.x);
  }
  bool operator==(const GridPlace&) const = default;
};

/// What lies between a cell's middle and a light.
struct Crossed {
  float strands = 0;  // that the light crosses on average
  float body = 0;     // optical depth of the skin
};

/// Two lights, so that a cell's numbers lie side by side; one that is not there crosses nothing.
using CrossedByTwo = std::array<Crossed, 2>;

class DensityGrid {
 public:
  /// Brings the grid up to date: fur where parts have changed, light where fur or lights have. Deterministic for any
  /// number of threads.
  void update(const FurModel& model, std::span<const GrownPart> parts, std::span<const FurLight> lights, int threads);

  const GridPlace& place() const { return place_; }
  /// Lights 2 pair and 2 pair + 1.
  const std::vector<CrossedByTwo>& crossed(std::size_t pair) const { return crossed_[pair]; }
  std::size_t bytes() const;

 private:
  /// Of a cell's face what strands across it cover, and that times their direction, in fixed point: sums do not depend
  /// on their order.
  struct Density {
    std::array<std::int32_t, 4> sum{};
  };

  bool add_fur(std::span<const GrownPart> parts, int threads);
  std::vector<float> skin_towards(const FurModel& model, const FurLight& light) const;
  Crossed own(std::size_t at, float skin, glm::vec3 to_light) const;
  glm::vec3 source_of(const FurLight& light) const;
  std::vector<Crossed> swept(const FurLight& light, const std::vector<float>& skin) const;
  Crossed between(const std::vector<Crossed>& cells, glm::vec3 at) const;
  void light_cells(const FurModel& model, const FurLight& light, std::size_t number);

  GridPlace place_;
  std::vector<Density> density_;
  std::vector<std::uint64_t> states_;  // of the parts that are in it
  std::uint64_t model_ = 0;
  std::vector<FurLight> lights_;       // that have been followed
  std::vector<std::vector<CrossedByTwo>> crossed_;
};

}  // namespace pelage
