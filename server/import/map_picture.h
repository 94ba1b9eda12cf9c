// An uploaded picture whose numbers are data: maps of fields, and masks.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/status.h"
#include "server/import/import.h"

namespace pelage {

/// The numbers of the file, without a conversion of sRGB: 8 and 16 bits are divided by 255 and 65535, floats are not
/// changed. Rows from the top, 4 * width * height finite numbers; red, green and blue are equal if the file is grey,
/// alpha is 1 if it has none.
struct MapPicture {
  int width = 0, height = 0;
  int bits = 8;                 // 8, 16, or 32 for any float
  std::optional<double> scale;  // value that 1 stands for, if the file gives it
  std::vector<float> rgba;
};

/// Reads a PNG, JPEG, EXR or HDR by the worker. Refused as import_picture, and (invalid, with the count) if numbers are
/// NaN or infinite.
Result<MapPicture> import_map(const std::string& worker, std::span<const std::byte> bytes,
                              const ImportLimits& limits = {});

/// The worker's answer, which the journal also stores. Samples of 8 and 16 bits are stored in 8 and 16 bits. Decoding
/// also accepts the bytes of encode_raw_image.
std::string encode_map_picture(const MapPicture& picture);
Result<MapPicture> decode_map_picture(std::span<const std::byte> bytes);

}  // namespace pelage
