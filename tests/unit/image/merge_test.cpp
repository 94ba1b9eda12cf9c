// A picture that was drawn in parts and merged is the same file as the whole picture.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "renderer/image/cropped.h"
#include "renderer/image/float_image.h"
#include "renderer/picture_files/picture_files.h"

namespace pelage {
namespace {

constexpr int width = 50, height = 37;

struct Region {
  int left, top, width, height;
};
const std::vector<Region> regions = {{0, 0, 20, 16}, {20, 0, 30, 16}, {0, 16, 20, 21}, {20, 16, 30, 21}};
const std::vector<ImageText> texts = {{"Software", "a test"}, {"pelage/frame", "7"}};

/// Random pixels: opaque in the left 20 columns, with random alpha elsewhere.
template <class Picture>
Picture noise() {
  using Number = typename decltype(Picture::rgba)::value_type;
  Picture picture;
  picture.width = width, picture.height = height;
  std::mt19937 random(3);
  for (int i = 0; i < width * height; ++i) {
    for (int c = 0; c < 3; ++c) picture.rgba.push_back(static_cast<Number>(random()));
    picture.rgba.push_back(i % width < 20 ? std::numeric_limits<Number>::max() : static_cast<Number>(random()));
  }
  return picture;
}

template <class Picture>
std::vector<PicturePart> parts_of(const Picture& picture, bool keep_alpha) {
  std::vector<PicturePart> parts;
  for (const Region& at : regions) {
    const Picture part = cropped(picture, at.left, at.top, at.width, at.height);
    parts.push_back({encode_png(part, keep_alpha), at.left, at.top});
  }
  return parts;
}

template <class Picture>
void expect_whole_png() {
  const Picture picture = noise<Picture>();
  for (const bool keep_alpha : {false, true}) {
    const auto merged = picture_files().merge_pictures(parts_of(picture, keep_alpha), width, height, keep_alpha, texts);
    ASSERT_TRUE(merged.ok()) << merged.status().message;
    EXPECT_TRUE(*merged == encode_png(picture, keep_alpha, texts)) << keep_alpha;
  }
}

TEST(Merge, MergesPngOf8And16Bits) {
  expect_whole_png<Image>();
  expect_whole_png<Image16>();
}

/// Colours stored as half floats and a depth stored as single floats, with values beyond the range of halves.
struct ExrNoise {
  FloatImage colour, depth;
};

ExrNoise exr_noise() {
  ExrNoise noise{{width, height, {}}, {width, height, {}}};
  std::mt19937 random(3);
  std::normal_distribution<float> any(0, 1000);
  for (int i = 0; i < 4 * width * height; ++i) {
    noise.colour.rgba.push_back(any(random) * any(random));  // some beyond 65504
    noise.depth.rgba.push_back(i % 11 == 0 ? std::numeric_limits<float>::infinity() : any(random));
  }
  return noise;
}

std::string exr_of(const ExrNoise& noise, const ExrWindow& window, std::span<const ImageText> says = {}) {
  std::vector<ExrPlane> planes = rgba_planes(noise.colour.rgba, ExrSample::half);
  planes.push_back({"Z", noise.depth.rgba, 0, 4, ExrSample::single});
  return picture_files().encode_exr(window, planes, says);
}

/// Texts that say how to read the channels.
const std::vector<ImageText> of_channels = {{"cryptomatte/1a2b3c4/name", "CryptoObject"},
                                            {colour_space_text, "ACEScg"}};

TEST(Merge, MergesExrAndKeepsTheTypesOfItsChannelsAndHowTheyAreRead) {
  const ExrNoise noise = exr_noise();
  std::vector<PicturePart> parts;
  for (const Region& at : regions) {
    const ExrNoise part{cropped(noise.colour, at.left, at.top, at.width, at.height),
                        cropped(noise.depth, at.left, at.top, at.width, at.height)};
    const std::vector<ImageText> says = {of_channels[0], of_channels[1], {"pelage/seconds", "1"}};
    parts.push_back({exr_of(part, {at.width, at.height, at.left, at.top, width, height}, says), at.left, at.top});
  }
  const auto merged = picture_files().merge_pictures(parts, width, height, false, texts);
  ASSERT_TRUE(merged.ok()) << merged.status().message;
  std::vector<ImageText> all(texts.begin(), texts.end());
  all.insert(all.end(), of_channels.begin(), of_channels.end());
  EXPECT_TRUE(*merged == exr_of(noise, {width, height}, all));
}

TEST(Merge, RefusesPartsThatDoNotFit) {
  const std::vector<PicturePart> png = parts_of(noise<Image>(), false), deep = parts_of(noise<Image16>(), false);
  const auto refused = [](const std::vector<PicturePart>& parts) {
    const auto merged = picture_files().merge_pictures(parts, width, height, false, texts);
    return !merged.ok() && merged.status().code == Code::invalid;
  };
  EXPECT_TRUE(refused({png[0], deep[1]}));
  EXPECT_TRUE(refused({png[0], {exr_of(exr_noise(), {width, height}), 0, 0}}));
  EXPECT_TRUE(refused({{png[0].bytes, 31, 0}}));
  EXPECT_TRUE(refused({{png[0].bytes, -1, 0}}));
  EXPECT_TRUE(refused({{png[0].bytes.substr(0, png[0].bytes.size() / 2), 0, 0}}));
  EXPECT_TRUE(refused({{"no picture", 0, 0}}));
}

TEST(Merge, ReadsWhatAFileSaysOfItself) {
  const std::string png = encode_png(noise<Image>(), false, texts);
  EXPECT_EQ(picture_files().text_in_picture(std::as_bytes(std::span(png)), "pelage/frame"), "7");
  EXPECT_EQ(picture_files().text_in_picture(std::as_bytes(std::span(png)), "pelage/other"), "");
  EXPECT_EQ(picture_files().text_in_picture(std::as_bytes(std::span(std::string_view("no picture"))), "pelage/frame"),
            "");
}

using Window = std::array<std::int32_t, 4>;  // first and last pixel: left, top, right, bottom

/// Reads a box attribute of an EXR's header: name, type, size and value (OpenEXR's "File Layout").
Window window_in(const std::string& exr, const std::string& name) {
  using namespace std::string_literals;
  const std::string before = name + "\0box2i\0\x10\0\0\0"s;
  const std::size_t at = exr.find(before);
  Window window{};
  if (at != std::string::npos) std::memcpy(window.data(), &exr[at + before.size()], sizeof window);
  return window;
}

TEST(Merge, AnExrOfAPartSaysWhereItLies) {
  const ExrNoise noise = exr_noise();
  const std::string exr = exr_of(noise, {width, height, 12, 34, 200, 100});
  EXPECT_EQ(window_in(exr, "dataWindow"), (Window{12, 34, 12 + width - 1, 34 + height - 1}));
  EXPECT_EQ(window_in(exr, "displayWindow"), (Window{0, 0, 199, 99}));
}

}  // namespace
}  // namespace pelage
