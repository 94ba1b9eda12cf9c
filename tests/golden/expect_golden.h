// Compares a picture with a golden one, which somebody has looked at.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "renderer/image/image.h"
#include "renderer/picture_files/picture_files.h"
#include "tests/support/furred_model.h"

namespace pelage::testing {

/// Thresholds are in 1/255. With PELAGE_UPDATE_GOLDEN=1 the picture replaces the golden one.
inline void expect_golden(const Image& image, const std::string& name, double mean, int largest) {
  const std::string path = PELAGE_GOLDEN_FOLDER "/" + name + ".png";
  if (std::getenv("PELAGE_UPDATE_GOLDEN")) {
    const std::string png = encode_png(image, true);
    std::ofstream(path, std::ios::binary).write(png.data(), static_cast<std::streamsize>(png.size()));
  }
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const Result<Image> expected = picture_files().decode_image(std::as_bytes(std::span(bytes)), 1 << 20);
  ASSERT_TRUE(expected.ok()) << path << ": " << expected.status().message;
  ASSERT_EQ(expected->rgba.size(), image.rgba.size());
  EXPECT_LE(mean_difference(image, *expected), mean) << name;
  EXPECT_LE(largest_difference(image, *expected), largest) << name;
}

}  // namespace pelage::testing
