// Arrays as NumPy's .npy files (format version 1.0, its NEP 1), which scripts read and write without an image library.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "renderer/image/float_image.h"

namespace pelage {

inline constexpr const char* npy_type = "application/x-npy";  // no media type is registered

/// Returns the file of an array in C order; the product of `shape` is the number of `values`.
std::string encode_npy(std::span<const std::size_t> shape, std::span<const float> values);
std::string encode_npy(std::span<const std::size_t> shape, std::span<const double> values);
std::string encode_npy(std::span<const std::size_t> shape, std::span<const std::uint8_t> values);

/// Returns true if the bytes begin like such a file.
bool is_npy(std::string_view bytes);

/// Decodes unsigned integers of 8 and 16 bits, and floats of 32 and 64 bits, little endian in C order; 64-bit numbers
/// beyond the 32-bit range become infinite. In the shapes [n] and [n, k] with k in [1, 4] each row is a pixel, and
/// `width` is 1; [height, width] with more than 4 columns is grey; [height, width, k] has k channels. One channel is
/// grey, two are red and green; alpha is 1 if there is none. Fails with invalid for other files, and if the file is cut
/// off, empty, or over `max_pixels`.
Result<DataImage> decode_npy(std::string_view bytes, std::size_t max_pixels);

}  // namespace pelage
