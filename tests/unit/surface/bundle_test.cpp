// Models packed with the files that they name, their poses, and what was left out.
#include "server/import_worker/bundle.h"

#include <gtest/gtest.h>
#include <zip.h>

#include <filesystem>
#include <fstream>

#include "clients/cli/pack/pack.h"
#include "server/import_worker/parse.h"
#include "server/import_worker/skeleton.h"

namespace pelage::bundle_test {
namespace {

namespace fs = std::filesystem;

/// A folder that is deleted after the test.
class Packing : public ::testing::Test {
 protected:
  Packing() : folder_(fs::temp_directory_path() / ("pelage_pack_" + std::to_string(getpid()))) {
    fs::create_directories(folder_ / "skins");
  }
  ~Packing() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& bytes) {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return (folder_ / name).string();
  }

  fs::path folder_;
};

std::size_t count_of(const RawModel& model, const char* code) {
  for (const Repair& loss : model.losses)
    if (loss.code == code) return loss.count;
  return 0;
}

constexpr const char* fox =
    "mtllib fox one.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl gone\nf 3 2 1\n";

TEST_F(Packing, AnObjGoesWithItsMaterialsAndPictures) {
  const std::string path = write("fox.obj", fox);
  write("fox one.mtl", "newmtl red\nKd 1 0 0\nmap_Kd -s 1 1 1 skins/red.png\n");
  write("skins/red.png", "no picture");
  const auto packed = pack_model(path, "obj", 1'000'000);
  ASSERT_TRUE(packed.ok()) << packed.status().message;
  EXPECT_TRUE(packed->is_zip);
  EXPECT_TRUE(packed->missing.empty());
  const auto model = parse_model(ModelFormat::zip, packed->bytes);
  ASSERT_TRUE(model.ok()) << model.status().message;
  ASSERT_EQ(model->materials.size(), 2u);
  EXPECT_EQ(model->materials[0].base_colour, glm::vec3(1, 0, 0));
  EXPECT_EQ(count_of(*model, "broken_pictures"), 1u);
  EXPECT_EQ(count_of(*model, "missing_materials"), 1u);
  EXPECT_EQ(count_of(*model, "missing_material_files"), 0u);
  const auto shape = parse_model(ModelFormat::zip, packed->bytes, "", false);
  ASSERT_TRUE(shape.ok()) << shape.status().message;
  EXPECT_EQ(count_of(*shape, "broken_pictures"), 0u) << "nobody looked";
  EXPECT_EQ(shape->positions, model->positions);
  EXPECT_EQ(shape->materials.size(), 2u);
}

TEST_F(Packing, WhatIsNotThereIsNamed) {
  const auto packed = pack_model(write("fox.obj", fox), "obj", 1'000'000);
  ASSERT_TRUE(packed.ok());
  EXPECT_FALSE(packed->is_zip);
  EXPECT_EQ(packed->missing, std::vector<std::string>{"fox one.mtl"});
  const auto model = parse_model(ModelFormat::obj, packed->bytes);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->losses.front().names, std::vector<std::string>{"fox one.mtl"});
}

TEST_F(Packing, NothingOutsideTheFolderIsRead) {
  write("secret.mtl", "newmtl red\n");
  fs::create_directories(folder_ / "models");
  const std::string path = write("models/fox.obj", "mtllib ../secret.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto packed = pack_model(path, "obj", 1'000'000);
  ASSERT_TRUE(packed.ok());
  EXPECT_EQ(packed->missing, std::vector<std::string>{"../secret.mtl"});
  EXPECT_FALSE(pack_model((folder_ / "none.obj").string(), "obj", 10).ok());
  EXPECT_EQ(pack_model(path, "obj", 10).status().code, Code::too_large);
}

TEST_F(Packing, ArchivesWithSeveralModelsOrNoneAreRefused) {
  const std::string path = write("fox.obj", "mtllib other.obj\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  write("other.obj", "v 0 0 0\n");
  ModelFormat format = ModelFormat::zip;
  const auto several = Bundle::unpack(pack_model(path, "obj", 1'000'000)->bytes, format);
  ASSERT_FALSE(several.ok());
  EXPECT_NE(several.status().message.find("other.obj"), std::string::npos);
  EXPECT_FALSE(Bundle::unpack("PK\x03\x04 and no more", format).ok());
}

TEST(Names, ListTheFilesThatModelsName) {
  EXPECT_EQ(names_in_obj(" mtllib a b.mtl \r\n#mtllib c\nmtllib a b.mtl\n"), std::vector<std::string>{"a b.mtl"});
  EXPECT_EQ(names_in_mtl("map_Kd a b.png\nmap_Kd -o 1 1 c.png\nmap_Bump d.png\n"),
            (std::vector<std::string>{"a b.png", "c.png"}));
  EXPECT_EQ(names_in_gltf(R"({"buffers": [{"uri": "a.bin"}, {"uri": "data:,x"}, {}], "images": [{"uri": "b.png"}]})"),
            (std::vector<std::string>{"a.bin", "b.png"}));
  EXPECT_TRUE(names_in_gltf("no JSON").empty());
}

TEST(Skeleton, ReadsTheSideFromTheNameOfAJoint) {
  for (const char* name :
       {"mixamorig:LeftArm", "Skeleton_arm_joint_L__4_", "l_ear", "Bip01 L Thigh", "paw.L", "LThigh"})
    EXPECT_EQ(side_of_joint(name), BodySide::left) << name;
  for (const char* name : {"b_RightLeg01_015", "leg_R", "R", "JOINT_R_1"})
    EXPECT_EQ(side_of_joint(name), BodySide::right) << name;
  for (const char* name : {"Tail", "spine_01", "ballrol", "", "Reference"})
    EXPECT_EQ(side_of_joint(name), BodySide::none) << name;
}

TEST(ParseGltf, PosesAreRefusedWhereThereAreNone) {
  const std::string triangle = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"name": "fox", "primitives": [{"attributes": {"POSITION": 0}},
      {"attributes": {"POSITION": 0}, "mode": 0}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "images": [{"uri": "fur.png"}],
    "buffers": [{"byteLength": 36, "uri": "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]})";
  const auto model = parse_model(ModelFormat::gltf, triangle);
  ASSERT_TRUE(model.ok()) << model.status().message;
  EXPECT_EQ(model->face_sizes.size(), 1u);
  EXPECT_EQ(count_of(*model, "points_and_lines"), 1u);
  EXPECT_EQ(count_of(*model, "missing_pictures"), 1u);
  const auto posed = parse_model(ModelFormat::gltf, triangle, "Walk@1");
  ASSERT_FALSE(posed.ok());
  EXPECT_NE(posed.status().message.find("no animation"), std::string::npos);
  EXPECT_FALSE(parse_model(ModelFormat::obj, "v 0 0 0\nf 1 1 1\n", "Walk@1").ok());
  std::string empty = triangle;
  empty.replace(empty.find("\"mode\": 0}"), 10, "\"mode\": 4}, {\"attributes\": {}}");
  EXPECT_NE(parse_model(ModelFormat::gltf, empty).status().message.find("\"fox\" has no vertices"), std::string::npos);
  std::string broken = triangle;
  broken.replace(broken.find("AAAAgD8AAAAA"), 4, "A!AA");
  EXPECT_NE(parse_model(ModelFormat::gltf, broken).status().message.find("base64"), std::string::npos);
}

// Imports a node that an animation lifts by 2 in one second.
TEST(ParseGltf, ModelsStandInTheirPose) {
  const std::string lifted = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "animations": [{"name": "Lift", "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}}],
                    "samplers": [{"input": 1, "output": 2}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
      {"bufferView": 1, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
      {"bufferView": 2, "componentType": 5126, "count": 2, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 8},
      {"buffer": 0, "byteOffset": 44, "byteLength": 24}],
    "buffers": [{"byteLength": 68, "uri": "data:;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAAAAAAAAQAAAAAA="}]})";
  const auto height = [&](const char* pose) {
    const auto model = parse_model(ModelFormat::gltf, lifted, pose);
    EXPECT_TRUE(model.ok()) << model.status().message;
    return model.ok() ? model->positions.front().y : -1;
  };
  EXPECT_EQ(height(""), 0);
  EXPECT_EQ(height("Lift"), 0);
  EXPECT_NEAR(height("Lift@0.25"), 0.5, 1e-5);
  EXPECT_NEAR(height("Lift@9"), 2, 1e-6);
  EXPECT_NE(parse_model(ModelFormat::gltf, lifted, "Walk").status().message.find("\"Lift\""), std::string::npos);
  EXPECT_FALSE(parse_model(ModelFormat::gltf, lifted, "Lift@soon").ok());
  EXPECT_FALSE(parse_model(ModelFormat::gltf, lifted, "Lift@-1").ok());
}

}  // namespace
}  // namespace pelage::bundle_test
