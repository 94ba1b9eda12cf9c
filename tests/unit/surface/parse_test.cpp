// The readers of model files, format by format.
#include "server/import_worker/parse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace pelage::parse_test {
namespace {

RawModel parsed(ModelFormat format, const std::string& bytes) {
  Result<RawModel> model = parse_model(format, bytes);
  EXPECT_TRUE(model.ok()) << (model.ok() ? "" : model.status().message);
  return model.ok() ? *model : RawModel();
}

std::string refusal(ModelFormat format, const std::string& bytes) {
  const Result<RawModel> model = parse_model(format, bytes);
  EXPECT_FALSE(model.ok());
  return model.ok() ? "" : model.status().message;
}

template <class T>
std::string bytes(T value, bool big_endian = false) {
  std::string text(reinterpret_cast<const char*>(&value), sizeof value);
  return big_endian ? std::string(text.rbegin(), text.rend()) : text;
}

TEST(ParseObj, ReadsPolygonsRelativeIndicesAndTextureCoordinates) {
  const RawModel model =
      parsed(ModelFormat::obj, "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0.5\nf -3/1 -2/2 3\nv 0 1 0\nf 1 2 3 -1\n");
  EXPECT_EQ(model.face_sizes, (std::vector<std::uint32_t>{3, 4}));
  EXPECT_EQ(model.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2, 3}));
  EXPECT_EQ(model.corner_uv[1], glm::dvec2(1, 0.5));
  EXPECT_TRUE(std::isnan(model.corner_uv[2].x));
}

TEST(ParseObj, NumbersAreRoundedCorrectlyAndOtherWordsAreNaN) {
  const RawModel model =
      parsed(ModelFormat::obj, "v 0.1 +2.5e-3 -1e20\nv nan 1.#IND 3.1+e2\nv 1e-400 1e400 0\nf 1 2 3");
  EXPECT_EQ(model.positions[0], glm::dvec3(0.1, 2.5e-3, -1e20));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(model.positions[1][i]));
  EXPECT_EQ(model.positions[2].x, 0);
  EXPECT_FALSE(std::isfinite(model.positions[2].y));
}

TEST(ParseObj, MissingVerticesAreMarked) {
  const RawModel model = parsed(ModelFormat::obj, "v 0 0 0\nf 1 2 -5\nf 0 1 1\n");
  EXPECT_EQ(model.corners, (std::vector<std::uint32_t>{0, no_position, no_position, no_position, 0, 0}));
}

TEST(ParseObj, VertexColoursBecomeLinear) {
  const RawModel model = parsed(ModelFormat::obj, "v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n");
  ASSERT_EQ(model.corner_colour.size(), 3u);
  EXPECT_NEAR(model.corner_colour[0].y, 0.21404, 1e-4);
  EXPECT_EQ(model.corner_colour[1], glm::vec4(1));
}

TEST(ParseObj, ReadsAnyLineEndsAndContinuations) {
  EXPECT_EQ(parsed(ModelFormat::obj, "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n").positions.size(), 3u);
  EXPECT_EQ(parsed(ModelFormat::obj, "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3").positions.size(), 3u);
  EXPECT_EQ(parsed(ModelFormat::obj, "\xef\xbb\xbfv 0 0 0\nv 1 0 \\\n0\nv 0 1 0\nf 1 \\\r\n2 3").corners.size(), 3u);
}

TEST(ParseStl, ReadsBinaryThatBeginsWithSolid) {
  std::string stl = "solid but binary";
  stl.resize(80, ' ');
  stl += bytes<std::uint32_t>(1);
  for (int i = 0; i < 12; ++i) stl += bytes(static_cast<float>(i * i));
  stl += std::string(2, '\0');
  const RawModel model = parsed(ModelFormat::stl, stl);
  EXPECT_EQ(model.positions.size(), 3u);
  EXPECT_EQ(model.positions[0], glm::dvec3(9, 16, 25));
  EXPECT_TRUE(model.is_32_bit);
  EXPECT_NE(refusal(ModelFormat::stl, stl.substr(0, 133)).find("room for 0"), std::string::npos);
}

TEST(ParseStl, CutOffTextIsRefused) {
  const std::string text = "solid a vertex\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n";
  EXPECT_EQ(parsed(ModelFormat::stl, text + "endloop\nendfacet\nendsolid\n").face_sizes.size(), 1u);
  EXPECT_NE(refusal(ModelFormat::stl, text).find("cut off"), std::string::npos);
  EXPECT_NE(refusal(ModelFormat::stl, "solid a\nfacet\nouter loop\nvertex 0 zero 0\n").find("number"),
            std::string::npos);
}

TEST(ParseOff, ReadsCommentsAndColoursAndMarksBadIndices) {
  const RawModel model = parsed(ModelFormat::off,
                                "COFF # colours\n3 2\n0 0 0 255 0 0 255\n# between\n1 0 0 0 255 0 255\n"
                                "0 1 0 0 0 255 255\n3 0 1 2\n3 0 1 9 0.5 0.5 0.5\n");
  EXPECT_EQ(model.corners, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, no_position}));
  EXPECT_EQ(model.corner_colour[1], glm::vec4(0, 1, 0, 1));
  EXPECT_FALSE(model.is_32_bit);
}

TEST(ParseOff, LyingCountsAreRefused) {
  EXPECT_NE(refusal(ModelFormat::off, "OFF\n4000000000 1 0\n0 0 0\n").find("counts"), std::string::npos);
  EXPECT_NE(refusal(ModelFormat::off, "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n").find("face 0"), std::string::npos);
  EXPECT_NE(refusal(ModelFormat::off, "4OFF\n1 1 1\n").find("4OFF"), std::string::npos);
}

const std::string ply_body =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
    "property uchar blue\nelement extra 1\nproperty list uchar short things\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n";

TEST(ParsePly, ReadsBigEndianWithColoursAndUnknownElements) {
  std::string ply = "ply\nformat binary_big_endian 1.0\n" + ply_body;
  for (float x : {0.0f, 1.0f, 0.5f}) {
    ply += bytes(x, true) + bytes(x * x, true) + bytes(2.0f, true) + std::string("\xff\x80\0", 3);
  }
  ply += std::string("\2\0\1\0\2", 5);
  ply += "\3" + bytes(0, true) + bytes(1, true) + bytes(7, true);
  const RawModel model = parsed(ModelFormat::ply, ply);
  EXPECT_EQ(model.positions[2], glm::dvec3(0.5, 0.25, 2));
  EXPECT_EQ(model.corners, (std::vector<std::uint32_t>{0, 1, no_position}));
  EXPECT_NEAR(model.corner_colour[0].y, 0.21586, 1e-4);
  EXPECT_TRUE(model.is_32_bit);
  for (std::size_t length = ply.size() - 1; length > 0; length -= 3) {
    EXPECT_FALSE(parse_model(ModelFormat::ply, ply.substr(0, length)).ok());
    if (length < 3) break;
  }
}

TEST(ParsePly, TextIsReadInDouble) {
  const RawModel model = parsed(ModelFormat::ply, "ply\nformat ascii 1.0\ncomment a\n" + ply_body +
                                                      "10000000.123 0 0 255 0 0\n1 0 0 0 0 0\n0 1 0 0 0 0\n"
                                                      "2 4 5\n3 0 1 2\n");
  EXPECT_EQ(model.positions[0].x, 10000000.123);
  EXPECT_FALSE(model.is_32_bit);
}

TEST(ParsePly, ListsLongerThanTheFileAreRefused) {
  const std::string header =
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uint int vertex_indices\nend_header\n";
  EXPECT_FALSE(refusal(ModelFormat::ply, header + "4000000000 1 2 3").empty());
  EXPECT_FALSE(refusal(ModelFormat::ply, header + "-1 1 2 3").empty());
  EXPECT_FALSE(refusal(ModelFormat::ply, header + "2.5 1 2 3").empty());
}

/// In a strip, -1 starts a new strip.
TEST(ParsePly, ReadsStripsOfTriangles) {
  const RawModel model =
      parsed(ModelFormat::ply,
             "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4\n");
  EXPECT_EQ(model.face_sizes, (std::vector<std::uint32_t>{3, 3, 3}));
  EXPECT_EQ(model.corners, (std::vector<std::uint32_t>{0, 1, 2, 1, 3, 2, 2, 3, 4}));
}

TEST(ParseGltf, AppliesNodeTransformsAndFactors) {
  const std::string gltf = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
    "nodes": [{"children": [1], "translation": [10, 0, 0]}, {"mesh": 0, "rotation": [0, 0, 0.70710678, 0.70710678]},
              {"mesh": 0, "scale": [-1, 1, 1]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 1]}}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                   "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri":
      "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  const RawModel model = parsed(ModelFormat::gltf, gltf);
  ASSERT_EQ(model.face_sizes, (std::vector<std::uint32_t>{3, 3}));
  EXPECT_NEAR(glm::length(model.positions[1] - glm::dvec3(10, 1, 0)), 0, 1e-6);
  EXPECT_NEAR(glm::length(model.positions[2] - glm::dvec3(9, 0, 0)), 0, 1e-6);
  EXPECT_EQ(model.positions[4], glm::dvec3(-1, 0, 0));
  EXPECT_EQ(model.corners, (std::vector<std::uint32_t>{0, 1, 2, 5, 4, 3})) << "the mirrored part is wound backwards";
  EXPECT_EQ(model.materials[model.face_material[0]].base_colour, glm::vec3(0.5f, 0.25f, 0.125f));
}

/// A triangle whose joint stands 5 up, with a hundredth of the scale that its inverse bind matrix undoes.
TEST(ParseGltf, SkinsStandAsTheirJointsSay) {
  const std::string bytes =
      "data:application/octet-stream;base64,"
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAA"
      "AAAAAAAAAIA/AAAAAAAAAAAAAAAAAADIQgAAAAAAAAAAAAAAAAAAAAAAAMhCAAAAAAAAAAAAAAAAAAAAAAAAyEIAAAAAAAAAAAAA"
      "AAAAAAAAAACAPw==";
  const RawModel model = parsed(ModelFormat::gltf, R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0, "skin": 0, "translation": [7, 0, 0]},
              {"name": "hip", "translation": [0, 5, 0], "scale": [0.01, 0.01, 0.01]}],
    "skins": [{"joints": [1], "inverseBindMatrices": 3}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5121, "count": 3, "type": "VEC4"},
                  {"bufferView": 2, "componentType": 5126, "count": 3, "type": "VEC4"},
                  {"bufferView": 3, "componentType": 5126, "count": 1, "type": "MAT4"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 12},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 48}, {"buffer": 0, "byteOffset": 96, "byteLength": 64}],
    "buffers": [{"byteLength": 160, "uri": ")" + bytes +
                                                       R"("}]})");
  ASSERT_EQ(model.positions.size(), 3u);
  EXPECT_NEAR(glm::length(model.positions[0] - glm::dvec3(0, 5, 0)), 0, 1e-6);
  EXPECT_NEAR(glm::length(model.positions[1] - glm::dvec3(1, 5, 0)), 0, 1e-6);
  EXPECT_NEAR(glm::length(model.positions[2] - glm::dvec3(0, 6, 0)), 0, 1e-6);
}

/// A triangle with a morph target that moves everything by 4 along z; its mesh gives it a weight of a quarter. `buffer`
/// names the source of its 72 bytes.
std::string morphed(const std::string& nodes, const std::string& buffer) {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": )" + nodes + R"(,
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "targets": [{"POSITION": 1}]}], "weights": [0.25]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 4], "max": [0, 0, 4]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 36}],
    "buffers": [{"byteLength": 72)" +
         buffer + "}]}";
}

constexpr const char* in_base64 =
    R"(, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIBAAAAAAAAAAAAAAIBAAAAAAAAAAAAAAIBA")";

template <class T>
std::string bytes_of(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

std::string glb_of(std::string document) {
  document.resize((document.size() + 3) / 4 * 4, ' ');
  std::string binary;
  for (const float number : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 4, 0, 0, 4, 0, 0, 4}) binary += bytes_of(number);
  const auto chunk = [](const std::string& type, const std::string& data) {
    return bytes_of(static_cast<std::uint32_t>(data.size())) + type + data;
  };
  const std::string chunks = chunk("JSON", document) + chunk(std::string("BIN\0", 4), binary);
  return "glTF" + bytes_of(std::uint32_t{2}) + bytes_of(static_cast<std::uint32_t>(12 + chunks.size())) + chunks;
}

TEST(ParseGltf, MorphTargetsCountByTheirWeights) {
  const RawModel model = parsed(ModelFormat::gltf, morphed(R"([{"mesh": 0}])", in_base64));
  ASSERT_EQ(model.positions.size(), 3u);
  EXPECT_NEAR(glm::length(model.positions[1] - glm::dvec3(1, 0, 1)), 0, 1e-6);
}

/// Two nodes share a mesh, and one of them has weights of its own.
TEST(ParseGltf, WeightsOfANodeTakeThePlaceOfItsMeshs) {
  const std::string nodes = R"([{"mesh": 0, "weights": [0.75], "children": [1]}, {"mesh": 0}])";
  for (const auto& [format, bytes] : {std::pair(ModelFormat::gltf, morphed(nodes, in_base64)),
                                      std::pair(ModelFormat::glb, glb_of(morphed(nodes, "")))}) {
    const RawModel model = parsed(format, bytes);
    ASSERT_EQ(model.positions.size(), 6u);
    EXPECT_NEAR(model.positions[1].z, 3, 1e-6) << "its own weight";
    EXPECT_NEAR(model.positions[4].z, 1, 1e-6) << "the mesh's";
  }
}

TEST(ParseGltf, OtherVersionsAndGraphsThatAreNoTreesAreRefused) {
  EXPECT_NE(refusal(ModelFormat::gltf, R"({"asset": {"version": "1.0"}})").find("1.0"), std::string::npos);
  EXPECT_NE(refusal(ModelFormat::gltf, R"({"asset": {"version": "2.0"}, "nodes": [{"children": [1]}, {},
                                          {"children": [1]}]})")
                .find("two parents"),
            std::string::npos);
}

/// The message names what the bytes are, and says what to do with them.
TEST(Signature, NamesWhatIsNoModelOfThatFormat) {
  using namespace std::string_literals;
  const struct {
    std::string bytes;
    const char* named;
  } rows[] = {{"\x1f\x8b\x08\0\0\0"s, "gzip"},
              {"PK\x03\x04..."s, "zip"},
              {"\xff\xd8\xff\xe0.."s, "skin-texture"},
              {"\x89PNG\r\n"s, "skin-texture"},
              {"Kaydara FBX Binary  \0"s, "GLB"},
              {"<!DOCTYPE html>"s, "web page"},
              {"version https://git-lfs.github.com/spec/v1"s, "git lfs pull"},
              {"\xff\xfev\0 \0"s, "UTF-8"},
              {"ply\nformat ascii 1.0\n"s, "--format ply"},
              {"OFF\n3 1 0\n"s, "--format off"},
              {"glTF\2\0\0\0"s, "--format glb"},
              {"{\"asset\": {\"version\": \"2.0\"}}"s, "--format gltf"},
              {"solid a\nfacet normal 0 0 1\n"s, "--format stl"}};
  for (const auto& row : rows)
    EXPECT_NE(refusal(ModelFormat::obj, row.bytes).find(row.named), std::string::npos) << row.named;
}

TEST(Signature, AByteOrderMarkOfUtf8IsNoPartOfTheText) {
  const std::string mark = "\xef\xbb\xbf";
  EXPECT_EQ(parsed(ModelFormat::obj, mark + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").positions.size(), 3u);
  EXPECT_EQ(parsed(ModelFormat::off, mark + "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").positions.size(), 3u);
}

TEST(ParseGltf, CompressedMeshesAreNamed) {
  const auto reason = [](const std::string& extension) {
    return refusal(ModelFormat::gltf, R"({"asset": {"version": "2.0"}, "extensionsRequired": [")" + extension + "\"]}");
  };
  EXPECT_NE(reason("KHR_draco_mesh_compression").find("Draco"), std::string::npos);
  EXPECT_NE(reason("EXT_meshopt_compression").find("meshopt"), std::string::npos);
  EXPECT_NE(reason("KHR_mesh_quantization").find("no scene"), std::string::npos);
  EXPECT_NE(refusal(ModelFormat::gltf, R"({"asset": {"version": "2.0"}})").find("no scene"), std::string::npos);
}

}  // namespace
}  // namespace pelage::parse_test
