// Arrays as NumPy's .npy files (format version 1.0, its NEP 1): what scripts read and write without a library of
// pictures.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "renderer/image/float_image.h"

namespace pelage {

inline constexpr const char* npy_type = "application/x-npy";  // no media type is registered

/// The file of an array in C order; `shape` is of as many numbers as there are `values`.
std::string encode_npy(std::span<const std::size_t> shape, std::span<const float> values);
std::string encode_npy(std::span<const std::size_t> shape, std::span<const double> values);
std::string encode_npy(std::span<const std::size_t> shape, std::span<const std::uint8_t> values);

/// Returns whether the bytes begin as such a file does.
bool is_npy(std::string_view bytes);

/// Numbers of 8 and 16 bits without a sign, and floats of 32 and 64 bits, little endian in C order; one of 64 bits
/// beyond the range of 32 becomes infinite. Of the shapes [n] and [n, k] with k in [1, 4] each row is a pixel, `width`
/// is 1; [height, width] with more than 4 columns is grey, [height, width, k] as it says. One number is grey, two are
/// red and green, and alpha is 1 where there is none. Refused (invalid) when it is something else, cut off, empty, or
/// over `max_pixels`.
Result<DataImage> decode_npy(std::string_view bytes, std::size_t max_pixels);

}  // namespace pelage
