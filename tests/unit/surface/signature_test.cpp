// Recognizes bytes that are not a model of the claimed format.
#include "server/import_worker/signature.h"

#include <gtest/gtest.h>

#include "server/import/import.h"

namespace pelage::signature_test {
namespace {

using namespace std::string_view_literals;

std::string said_of(ModelFormat format, std::string_view bytes) {
  const Status status = check_signature(format, bytes);
  return status.ok() ? "" : status.message;
}

TEST(Signature, SaysWhatOtherFilesAre) {
  const std::pair<std::string_view, const char*> others[] = {
      {"\x1f\x8b\x08\x00"sv, "gzip"},
      {"\xff\xd8\xff\xe0"sv, "a JPEG picture"},
      {"Kaydara FBX Binary  "sv, "an FBX file"},
      {"<!DOCTYPE html><html>"sv, "a web page"},
      {"version https://git-lfs.github.com/spec/v1\n"sv, "git lfs pull"},
      {"\xff\xfev\0 \0"sv, "text in UTF-16"}};
  for (const auto& [bytes, words] : others) {
    for (const ModelFormat format : {ModelFormat::obj, ModelFormat::stl, ModelFormat::glb})
      EXPECT_NE(said_of(format, bytes).find(words), std::string::npos) << words;
  }
}

TEST(Signature, NamesTheFormatOfAModel) {
  const std::pair<std::string_view, ModelFormat> models[] = {
      {"ply\nformat ascii 1.0\n"sv, ModelFormat::ply},
      {"glTF\x02\0\0\0"sv, ModelFormat::glb},
      {"OFF\n3 1 0\n"sv, ModelFormat::off},
      {"solid cow\n facet normal 0 0 1\n"sv, ModelFormat::stl},
      {" {\"asset\": {\"version\": \"2.0\"}}"sv, ModelFormat::gltf},
      {"# a cow\nv 0 0 0\nv 1 0 0\n"sv, ModelFormat::obj},
      {"\xef\xbb\xbfv 0 0 0\n"sv, ModelFormat::obj}};
  for (const auto& [bytes, format] : models) {
    const std::string name = worker_format_names[static_cast<std::size_t>(format)];
    EXPECT_EQ(said_of(format, bytes), "") << name;
    const ModelFormat other = format == ModelFormat::obj ? ModelFormat::stl : ModelFormat::obj;
    EXPECT_NE(said_of(other, bytes).find("load it with --format " + name), std::string::npos) << name;
  }
}

TEST(Signature, LeavesBinaryStlAlone) {
  std::string stl("v an odd header\nv 1\n");
  stl.resize(84, '\0');
  EXPECT_EQ(said_of(ModelFormat::stl, stl), "");
}

}  // namespace
}  // namespace pelage::signature_test
