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

/// The numbers as the file has them, no curve undone: of 8 and 16 bits over 255 and 65535, of floats themselves. Rows
/// from the top, 4 * width * height finite numbers; red, green and blue are equal where the file is grey, alpha is 1
/// where it has none.
struct MapPicture {
  int width = 0, height = 0;
  int bits = 8;                 // 8, 16, or 32 for any float
  std::optional<double> scale;  // what the file says that 1 stands for
  std::vector<float> rgba;
};

/// The picture of a PNG, JPEG, EXR or HDR, read by the worker; refused as import_picture, and (invalid, with the count)
/// where numbers are NaN or infinite.
Result<MapPicture> import_map(const std::string& worker, std::span<const std::byte> bytes,
                              const ImportLimits& limits = {});

/// The worker's answer, also what the journal stores: 8 and 16 bits take as much. Decoding takes encode_raw_image too.
std::string encode_map_picture(const MapPicture& picture);
Result<MapPicture> decode_map_picture(std::span<const std::byte> bytes);

}  // namespace pelage
