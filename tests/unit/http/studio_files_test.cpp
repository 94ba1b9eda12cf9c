#include <gtest/gtest.h>
#include <zlib.h>

#include <set>
#include <string>

#include "server/http/studio.h"

namespace pelage {
namespace {

std::string unzipped(std::string_view bytes, std::size_t size) {
  std::string plain(size + 1, '\0');
  z_stream stream{};
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(plain.data());
  stream.avail_out = static_cast<uInt>(plain.size());
  EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  plain.resize(stream.total_out);
  inflateEnd(&stream);
  return plain;
}

bool is_beside_the_page(std::string_view path) {
  return path == "/openapi.json" || path.starts_with("/assets/") || path.starts_with("/docs/");
}

TEST(StudioFiles, HasThePageContractAssetsAndReferenceOnly) {
  const StudioFile* page = find_studio_file("/");
  ASSERT_NE(page, nullptr);
  EXPECT_TRUE(page->identity.starts_with("<!doctype html>"));
  EXPECT_EQ(page->identity.substr(page->identity.size() - 8), "</html>\n");
  EXPECT_FALSE(page->hashed);
  for (const char* none : {"", "/index.html", "/assets/", "/assets", "/assets/none.js", "/docs", "/docs/",
                           "/docs/none.html", "/../etc/passwd"}) {
    EXPECT_EQ(find_studio_file(none), nullptr) << none;
  }
  for (const StudioFile& file : studio_files()) EXPECT_TRUE(&file == page || is_beside_the_page(file.path));
  ASSERT_NE(find_studio_file("/docs/index.html"), nullptr);
  EXPECT_FALSE(find_studio_file("/docs/style.css")->hashed);
  ASSERT_NE(find_studio_file("/openapi.json"), nullptr);
  EXPECT_TRUE(find_studio_file("/openapi.json")->identity.starts_with(R"({"openapi":"3.1.0")"));
}

TEST(StudioFiles, EachIsFoundByItsPathAndHasATagOfWhatItHolds) {
  std::set<std::string_view> paths, tags, contents;
  for (const StudioFile& file : studio_files()) {
    EXPECT_EQ(find_studio_file(file.path), &file);
    EXPECT_FALSE(file.identity.empty() || file.type.empty() || file.etag.empty()) << file.path;
    paths.insert(file.path), tags.insert(file.etag), contents.insert(file.identity);
  }
  EXPECT_EQ(paths.size(), studio_files().size());
  EXPECT_EQ(tags.size(), contents.size());
}

TEST(StudioFiles, CompressedFormsAreShorterAndHoldTheSame) {
  for (const StudioFile& file : studio_files()) {
    EXPECT_TRUE(file.brotli.empty() || file.brotli.size() < file.identity.size()) << file.path;
    if (file.gzip.empty()) continue;
    EXPECT_LT(file.gzip.size(), file.identity.size()) << file.path;
    EXPECT_EQ(unzipped(file.gzip, file.identity.size()), file.identity) << file.path;
  }
}

}  // namespace
}  // namespace pelage
