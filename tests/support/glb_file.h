// Reads a GLB as a client does; written independently of the writer.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pelage::testing {

struct GlbFile {
  nlohmann::json json;
  std::string binary;

  explicit GlbFile(const std::string& bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(number<std::uint32_t>(bytes, 4), 2u);
    EXPECT_EQ(number<std::uint32_t>(bytes, 8), bytes.size());
    const std::size_t json_bytes = number<std::uint32_t>(bytes, 12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    EXPECT_EQ(json_bytes % 4, 0u);
    json = nlohmann::json::parse(bytes.substr(20, json_bytes));
    const std::size_t binary_at = 20 + json_bytes;
    EXPECT_EQ(bytes.substr(binary_at + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(number<std::uint32_t>(bytes, binary_at), bytes.size() - binary_at - 8);
    EXPECT_EQ(bytes.size() % 4, 0u);
    binary = bytes.substr(binary_at + 8);
    EXPECT_LE(json["buffers"][0]["byteLength"], binary.size());
    EXPECT_GT(json["buffers"][0]["byteLength"].get<std::size_t>() + 4, binary.size());
  }

  template <class T>
  static T number(const std::string& bytes, std::size_t at) {
    T value{};
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }

  const nlohmann::json& primitive() const { return json["meshes"][0]["primitives"][0]; }

  /// Elements of an accessor; its buffer view has to hold them all.
  template <class T>
  std::vector<T> elements(int accessor) const {
    const nlohmann::json& about = json["accessors"][accessor];
    const nlohmann::json& view = json["bufferViews"][about["bufferView"].get<std::size_t>()];
    const std::size_t begin = view.value("byteOffset", std::size_t{0}), count = about["count"];
    EXPECT_EQ(view["byteLength"], count * sizeof(T));
    EXPECT_EQ(begin % 4, 0u);
    EXPECT_LE(begin + count * sizeof(T), json["buffers"][0]["byteLength"]);
    std::vector<T> values(count);
    std::memcpy(values.data(), binary.data() + begin, count * sizeof(T));
    return values;
  }

  std::vector<glm::vec3> vectors(const char* attribute) const {
    const int accessor = primitive()["attributes"][attribute];
    EXPECT_EQ(json["accessors"][accessor]["componentType"], 5126);
    EXPECT_EQ(json["accessors"][accessor]["type"], "VEC3");
    return elements<glm::vec3>(accessor);
  }

  bool has_short_indices() const {
    return json["accessors"][primitive()["indices"].get<std::size_t>()]["componentType"] == 5123;
  }

  std::vector<std::uint32_t> indices() const {
    const int accessor = primitive()["indices"];
    EXPECT_EQ(json["accessors"][accessor]["type"], "SCALAR");
    if (!has_short_indices()) return elements<std::uint32_t>(accessor);
    const auto shorts = elements<std::uint16_t>(accessor);
    return {shorts.begin(), shorts.end()};
  }

  glm::dvec3 translation() const {
    const nlohmann::json& node = json["nodes"][0];
    return {node["translation"][0], node["translation"][1], node["translation"][2]};
  }
};

}  // namespace pelage::testing
