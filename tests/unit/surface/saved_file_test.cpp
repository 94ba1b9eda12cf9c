// The confined worker reads exported scenes and guide curves.
#include <gtest/gtest.h>
#include <zlib.h>

#include "server/import/import.h"
#include "server/import_worker/read_saved_scene.h"

namespace pelage::saved_file_test {
namespace {

std::string packed(const std::string& bytes) {
  z_stream stream = {};
  EXPECT_EQ(deflateInit2(&stream, 1, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string file(deflateBound(&stream, bytes.size()), '\0');
  std::string copy = bytes;
  stream.next_in = reinterpret_cast<Bytef*>(copy.data()), stream.avail_in = static_cast<uInt>(copy.size());
  stream.next_out = reinterpret_cast<Bytef*>(file.data()), stream.avail_out = static_cast<uInt>(file.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  file.resize(stream.total_out);
  deflateEnd(&stream);
  return file;
}

std::string refusal(std::string file, std::size_t max = 1 << 20) {
  const Result<std::string> rows = read_saved_scene(std::move(file), max);
  return rows ? "" : rows.status().message;
}

TEST(SavedFile, WhatIsNoGzipFileOfADatabaseIsRefused) {
  const std::string noise(10'000, 'x'), file = packed(noise);
  EXPECT_EQ(refusal(""), "it is not a gzip file.");
  EXPECT_EQ(refusal(noise), "it is not a gzip file.");
  EXPECT_EQ(refusal(file.substr(0, file.size() / 2)), "it is damaged or cut off.");
  EXPECT_EQ(refusal(file + "more"), "it is damaged or cut off.");
  EXPECT_NE(refusal(file).find("not a database"), std::string::npos) << refusal(file);
}

TEST(SavedFile, RefusesADecompressionBomb) {
  const std::string bomb = packed(std::string(20 << 20, '\0'));
  EXPECT_LT(bomb.size(), 200'000u);
  EXPECT_EQ(refusal(bomb), "it is larger than 1048576 bytes unpacked.");
}

TEST(SavedFile, TheServerTakesNothingOfARefusedFile) {
  const std::string file = packed("SQLite format 3");
  std::size_t taken = 0;
  const Status status = import_saved(PELAGE_IMPORT, std::as_bytes(std::span(file)), [&](std::string_view bytes) {
    taken += bytes.size();
    return Status{};
  });
  EXPECT_EQ(status.code, Code::invalid);
  EXPECT_EQ(taken, 0u);
}

TEST(GuideFile, ComesThroughTheWorker) {
  const std::string json = R"({"curves": [[[0, 0, 0], [1, 2.5, 3]], [[4, 5, 6], [7, 8, 9], [1, 1, 1]]]})";
  const auto file = import_guides(PELAGE_IMPORT, GuideFormat::json, std::as_bytes(std::span(json)));
  ASSERT_TRUE(file.ok()) << file.status().message;
  ASSERT_EQ(file->curves.size(), 2u);
  EXPECT_EQ(file->curves[0][1], glm::dvec3(1, 2.5, 3));
  EXPECT_EQ(file->curves[1].size(), 3u);
  EXPECT_FALSE(file->up || file->metres);
  const auto none = import_guides(PELAGE_IMPORT, GuideFormat::hair, std::as_bytes(std::span(json)));
  EXPECT_EQ(none.status().code, Code::invalid);
  EXPECT_NE(none.status().message.find("does not begin as HAIR does"), std::string::npos) << none.status().message;
}

TEST(GuideFile, TheWorkersAnswerIsChecked) {
  const auto decoded = [](std::vector<GuideCurve> curves, std::size_t cut = 0) {
    const std::string bytes = encode_guides({std::move(curves)});
    return decode_guides(std::as_bytes(std::span(bytes)).first(bytes.size() - cut)).ok();
  };
  EXPECT_TRUE(decoded({{{0, 0, 0}, {1, 1, 1}}}));
  EXPECT_FALSE(decoded({{{0, 0, 0}}})) << "one point";
  EXPECT_FALSE(decoded({{{0, 0, 0}, {1, std::numeric_limits<double>::infinity(), 1}}}));
  EXPECT_FALSE(decoded({{{0, 0, 0}, {1, 1, 1}}}, 1)) << "cut off";
  const std::string said = encode_guides({{{{0, 0, 0}, {1, 1, 1}}}, Axis::plus_z, 0.01});
  const auto back = decode_guides(std::as_bytes(std::span(said)));
  ASSERT_TRUE(back.ok());
  EXPECT_EQ(back->up, Axis::plus_z);
  EXPECT_EQ(back->metres, 0.01);
}

}  // namespace
}  // namespace pelage::saved_file_test
