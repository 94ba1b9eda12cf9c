// NumPy files, written and read, and files that are not NumPy's.
#include "renderer/image/npy.h"

#include <gtest/gtest.h>

#include <array>

namespace pelage {
namespace {

constexpr std::size_t many = 1 << 20;

std::string of_floats(std::vector<std::size_t> shape, const std::vector<float>& values) {
  return encode_npy(shape, std::span(values));
}

DataImage read_npy(const std::string& bytes) {
  const Result<DataImage> image = decode_npy(bytes, many);
  EXPECT_TRUE(image.ok()) << image.status().message;
  return image.ok() ? *image : DataImage{};
}

// The header that numpy.save writes. The end-to-end tests read our files with numpy.load.
TEST(Npy, TheHeaderIsThatOfItsVersionOne) {
  const std::string file = of_floats({2, 3}, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(file.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
  EXPECT_EQ(file.size(), 128 + 6 * sizeof(float));
  EXPECT_NE(file.find("{'descr': '<f4', 'fortran_order': False, 'shape': (2,3,), }"), std::string::npos);
  EXPECT_EQ(file[127], '\n');
}

TEST(Npy, EachShapeIsReadAsWhatItIs) {
  const DataImage list = read_npy(of_floats({5}, {0, 1, 2, 3, 4}));
  EXPECT_EQ(list.width, 1);
  EXPECT_EQ(list.height, 5);
  EXPECT_EQ(list.rgba[4 * 3 + 2], 3);  // grey
  const DataImage vectors = read_npy(of_floats({2, 3}, {1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(vectors.width, 1);
  EXPECT_EQ(std::vector<float>(vectors.rgba.begin() + 4, vectors.rgba.end()), (std::vector<float>{4, 5, 6, 1}));
  const DataImage pairs = read_npy(of_floats({2, 1, 2}, {1, 2, 3, 4}));
  EXPECT_EQ(std::vector<float>(pairs.rgba.begin(), pairs.rgba.begin() + 4), (std::vector<float>{1, 2, 0, 1}));
  const DataImage grey = read_npy(of_floats({1, 6}, {1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(grey.width, 6);
  EXPECT_EQ(grey.bits, 32);
}

TEST(Npy, NumbersOfEightBitsAreOverTheirLargest) {
  const std::array<std::size_t, 3> shape{1, 1, 4};
  const std::array<std::uint8_t, 4> values{0, 255, 51, 255};
  const DataImage image = read_npy(encode_npy(shape, values));
  EXPECT_EQ(image.bits, 8);
  EXPECT_EQ(image.rgba, (std::vector<float>{0, 1, 0.2f, 1}));
}

TEST(Npy, WhatIsNoPictureIsRefused) {
  const std::string good = of_floats({2, 3}, {1, 2, 3, 4, 5, 6});
  for (std::size_t size = 6; size < good.size(); ++size)
    EXPECT_FALSE(decode_npy(good.substr(0, size), many).ok()) << size;
  EXPECT_FALSE(decode_npy(of_floats({0}, {}), many).ok());
  EXPECT_FALSE(decode_npy(of_floats({1, 1, 1, 1}, {1}), many).ok());
  EXPECT_FALSE(decode_npy(of_floats({2, 3}, {1, 2, 3, 4, 5, 6}), 1).ok());
  std::string fortran = good, huge = good;
  fortran.replace(fortran.find("False"), 5, "True ");
  EXPECT_NE(decode_npy(fortran, many).status().message.find("C order"), std::string::npos);
  huge.replace(huge.find("(2,3,)"), 24, "(9999999999,9999999999,)");
  EXPECT_FALSE(decode_npy(huge, many).ok());
}

}  // namespace
}  // namespace pelage
