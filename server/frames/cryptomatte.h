// Cryptomatte: which objects cover each pixel, and how much, as channels and a manifest of an EXR. By Psyop's
// "Cryptomatte Specification", version 1.2.0.
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

/// MurmurHash3 of 32 bits (x86, seed 0) of a name, read as a float. The last bit of an exponent of 0 or 255 is flipped,
/// so that all are finite and normal.
float matte_id(std::string_view name);

/// Which objects cover the pixels of a frame.
class Cryptomatte {
 public:
  /// `shares`: Aov::objects_1 to objects_4 of the frame, of one size.
  Cryptomatte(const FurFrame& frame, std::span<const FloatImage> shares);

  /// CryptoObject00 to 02: id and share of the six objects that cover most of a pixel, most first; 0 where there are
  /// fewer. The views last as long as this does.
  std::vector<ExrPlane> planes() const;
  /// The layer's name, how it was hashed, and the id of each name as a manifest.
  std::vector<ImageText> texts() const;

 private:
  std::vector<std::pair<std::string, float>> objects_;  // names with their ids, by their numbers
  std::vector<FloatImage> ranks_;                       // id, share, id, share of each pixel
};

}  // namespace pelage
