#include "server/http/embedded_files.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <set>
#include <string>

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

TEST(EmbeddedFiles, HasThePageContractAssetsAndReferenceOnly) {
  const EmbeddedFile* page = find_embedded_file("/");
  ASSERT_NE(page, nullptr);
  EXPECT_TRUE(page->identity.starts_with("<!doctype html>"));
  EXPECT_EQ(page->identity.substr(page->identity.size() - 8), "</html>\n");
  EXPECT_FALSE(page->hashed);
  for (const char* none : {"", "/index.html", "/assets/", "/assets", "/assets/none.js", "/docs", "/docs/",
                           "/docs/none.html", "/../etc/passwd"}) {
    EXPECT_EQ(find_embedded_file(none), nullptr) << none;
  }
  for (const EmbeddedFile& file : embedded_files()) EXPECT_TRUE(&file == page || is_beside_the_page(file.path));
  ASSERT_NE(find_embedded_file("/docs/index.html"), nullptr);
  EXPECT_FALSE(find_embedded_file("/docs/style.css")->hashed);
  ASSERT_NE(find_embedded_file("/openapi.json"), nullptr);
  EXPECT_TRUE(find_embedded_file("/openapi.json")->identity.starts_with(R"({"openapi":"3.1.0")"));
}

TEST(EmbeddedFiles, EachIsFoundByItsPathAndHasATagOfWhatItHolds) {
  std::set<std::string_view> paths, tags, contents;
  for (const EmbeddedFile& file : embedded_files()) {
    EXPECT_EQ(find_embedded_file(file.path), &file);
    EXPECT_FALSE(file.identity.empty() || file.type.empty() || file.etag.empty()) << file.path;
    paths.insert(file.path), tags.insert(file.etag), contents.insert(file.identity);
  }
  EXPECT_EQ(paths.size(), embedded_files().size());
  EXPECT_EQ(tags.size(), contents.size());
}

TEST(EmbeddedFiles, CompressedFormsAreShorterAndHoldTheSame) {
  for (const EmbeddedFile& file : embedded_files()) {
    EXPECT_TRUE(file.brotli.empty() || file.brotli.size() < file.identity.size()) << file.path;
    if (file.gzip.empty()) continue;
    EXPECT_LT(file.gzip.size(), file.identity.size()) << file.path;
    EXPECT_EQ(unzipped(file.gzip, file.identity.size()), file.identity) << file.path;
  }
}

}  // namespace
}  // namespace pelage
