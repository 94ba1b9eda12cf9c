// Cryptomatte: the objects that cover each pixel and their coverage, as channels and a manifest of an EXR. Follows
// Psyop's "Cryptomatte Specification", version 1.2.0.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/image/float_image.h"
#include "renderer/image/image.h"
#include "renderer/input/fur_scene.h"

namespace pelage {

/// Returns the 32-bit MurmurHash3 (x86, seed 0) of a name, reinterpreted as a float. The last bit of an exponent of 0
/// or 255 is flipped, so that all ids are finite and normal.
float matte_id(std::string_view name);

/// The Cryptomatte data of a frame.
class Cryptomatte {
 public:
  /// `shares` are the AOVs objects_1 to objects_4 of the frame, all of one size.
  Cryptomatte(const FurFrame& frame, std::span<const FloatImage> shares);

  /// Returns CryptoObject00 to 02: ids and coverages of the six objects with the highest coverage of each pixel,
  /// highest first; 0 if there are fewer. The planes are views that are valid as long as this object.
  std::vector<ExrPlane> planes() const;
  /// Returns the metadata: the EXR layer's name, the hash, and the manifest with the id of each name.
  std::vector<ImageText> texts() const;

 private:
  std::vector<std::pair<std::string, float>> objects_;  // names and ids, by object number
  std::vector<FloatImage> ranks_;                       // for each pixel: id, coverage, id, coverage
};

}  // namespace pelage
