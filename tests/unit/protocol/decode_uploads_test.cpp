// Uploads and their queries: environments, pictures, maps, meshes, the layout of fur.
#include "tests/unit/protocol/refusals.h"

namespace pelage {
namespace {

std::string environment_with(const std::string& members) {
  return R"({"op": "set_environment", "environment": {)" + members + "}}";
}

TEST(Decode, EnvironmentsAreAGradientOrHarmonics) {
  const std::string nine = R"("harmonics": [)" + repeated("[1, -2, 1e6]", 9) + "]";
  EXPECT_TRUE(refusal(environment_with("")).ok());
  EXPECT_TRUE(refusal(environment_with(nine + R"(, "turn_degrees": -360, "intensity": 2)")).ok());
  const std::string at = "/environment/";
  expect_refusal(environment_with(nine + R"(, "ground": [1, 1, 1])"), Code::invalid, at + "harmonics");
  expect_refusal(environment_with(R"("turn_degrees": 3)"), Code::invalid, at + "turn_degrees");
  expect_refusal(environment_with(nine + R"(, "turn_degrees": 361)"), Code::invalid, at + "turn_degrees");
  expect_refusal(environment_with(R"("harmonics": [)" + repeated("[0, 0, 0]", 8) + "]"), Code::invalid,
                 at + "harmonics");
  expect_refusal(environment_with(R"("harmonics": [)" + repeated("[0, 0, 0]", 8) + ", [0, 1.1e6, 0]]"), Code::invalid,
                 at + "harmonics/8/1");
}

TEST(Decode, EnvironmentQueriesHaveDefaultsAndLimits) {
  EXPECT_EQ(decode_environment_query({})->environment.intensity, 1);
  EXPECT_EQ(decode_environment_query({{"turn_degrees", "-90"}, {"intensity", "2"}})->environment.turn_degrees, -90);
  EXPECT_EQ(decode_environment_query({{"colour_space", "ACEScg"}})->colour_space, "ACEScg");
  EXPECT_EQ(decode_environment_query({{"intensity", "-1"}}).status().pointer, "/intensity");
  EXPECT_EQ(decode_environment_query({{"intensiti", "1"}}).status().nearest, "intensity");
}

TEST(Decode, PicturesAreNamedByHexDigits) {
  const auto named = [](const std::string& name) {
    return R"({"op": "set_skin_texture", "picture": ")" + name + "\"}";
  };
  EXPECT_TRUE(refusal(named("own")).ok());
  EXPECT_TRUE(refusal(named("0123456789abcdef0123456789abcdef")).ok());
  for (const std::string bad : {"", "Own", "0123456789abcdef0123456789abcde", "0123456789ABCDEF0123456789abcdef",
                                "0123456789abcdef0123456789abcdef0"}) {
    expect_refusal(named(bad), Code::invalid, "/picture");
  }
  expect_refusal(R"({"op": "set_skin_texture"})", Code::invalid, "/picture");
}

TEST(Decode, MapsAreOfOneFieldInAnEncodingThatHoldsIt) {
  const std::string picture = R"({"op": "map", "picture": "0123456789abcdef0123456789abcdef")";
  const auto plain = decode_commands(picture + "}");
  ASSERT_TRUE(plain.ok());
  EXPECT_EQ(std::get<ApplyMap>(plain->front()).field, Field::length);
  EXPECT_TRUE(refusal(picture + R"(, "field": "direction", "encoding": "vector"})").ok());
  expect_refusal(picture + R"(, "field": "direction", "encoding": "value"})", Code::invalid, "/encoding");
  expect_refusal(picture + R"(, "field": "mask", "encoding": "fast_fur"})", Code::invalid, "/encoding");
  expect_refusal(picture + R"(, "scale": 0})", Code::invalid, "/scale");
  expect_refusal(R"({"op": "map"})", Code::invalid, "/picture");
  expect_refusal(R"({"op": "mask", "picture": {"name": "own"}})", Code::invalid, "/picture/name");
  const auto map =
      decode_map_query({{"field", "direction"}, {"format", "exr"}, {"encoding", "vector"}, {"size", "8192"}});
  ASSERT_TRUE(map.ok());
  EXPECT_EQ(map->size, 8192);
  EXPECT_EQ(decode_map_query({{"field", "direction"}, {"encoding", "vector"}}).status().pointer, "/format");
  EXPECT_EQ(decode_map_query({{"field", "lenght"}}).status().nearest, "length");
  EXPECT_EQ(decode_map_upload_query({{"field", "mask"}, {"strength", "2"}}).status().pointer, "/strength");
  EXPECT_FALSE(decode_map_upload_query({{"field", "mask"}})->scale);
}

TEST(Decode, MeshQueriesHaveDefaultsAndLimits) {
  EXPECT_EQ(decode_mesh_query({})->triangles, 20'000);
  EXPECT_EQ(decode_mesh_query({{"triangles", "100"}})->triangles, 100);
  EXPECT_EQ(decode_mesh_query({{"triangles", "0"}}).status().pointer, "/triangles");
  EXPECT_EQ(decode_mesh_query({{"triangles", "200001"}}).status().limit, "[100, 200000]");
}

TEST(Decode, ReadsHowFurIsLaid) {
  EXPECT_EQ(decode_new_scene("{}")->fur_patches, FurPatches::overlapping);
  EXPECT_EQ(decode_new_scene(R"({"fur_patches": "hard"})")->fur_patches, FurPatches::hard);
  EXPECT_EQ(decode_new_scene(R"({"fur_patches": "own_uv"})").status().nearest, "own_uvs");
  EXPECT_EQ(decode_import_query({{"format", "obj"}, {"fur_patches", "own_uvs"}})->fur_patches, FurPatches::own_uvs);
  EXPECT_EQ(decode_import_query({{"format", "obj"}, {"fur_patches", "soft"}}).status().pointer, "/fur_patches");
}

}  // namespace
}  // namespace pelage
