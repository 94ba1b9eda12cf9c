// GLBs of baked shells and of fields, read independently of their writers.
#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/coat/slices.h"
#include "server/export/corner_mesh.h"
#include "server/export/mesh_fields.h"
#include "server/export/shell_texture.h"
#include "server/export/shells.h"
#include "server/export/vertex_colours.h"
#include "tests/support/furred_model.h"
#include "tests/support/glb_file.h"
#include "tests/unit/export/maned.h"

namespace pelage::testing {
namespace {

FurredModel furred_ball() { return furred({Builtin::sphere, 500}, {.length = 0.05, .inclination = 0.5}); }

ExportedStrands strands_of(const FurredModel& model, int every = 16) {
  ExportRequest request;
  request.every = every;
  return gather_strands(model.view(), request).value();
}

TEST(ShellTextures, AreAsOpaqueAsTheirStrands) {
  const Slices slices = bake_slices(Coat{});
  const SliceLevel& level = slices.levels[1];
  for (const int shell_count : {4, 16}) {
    for (int shell = 0; shell < shell_count; ++shell) {
      const SliceBin bin = bin_of(shell, shell_count);
      const std::size_t count = static_cast<std::size_t>(level.texels) * static_cast<std::size_t>(level.texels);
      double covered = 0;
      for (std::size_t i = 0; i < count; ++i) {
        double depth = 0;
        for (int s = bin.first; s < bin.last; ++s)
          depth += level.shape[4 * (static_cast<std::size_t>(s) * count + i) + 3] / 255.0 * stored_depth *
                   level.depth_scale[0];
        covered += 1 - std::exp(-depth);
      }
      const Image image = ShellTexture(level, bin).image();
      double opaque = 0;
      for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque += image.rgba[i] / 255.0;
      EXPECT_NEAR(opaque / static_cast<double>(count), covered / static_cast<double>(count), 0.002) << shell;
    }
  }
}

TEST(BakedShells, HaveASkinAndTheShellsThatWereRequested) {
  const FurredModel model = furred_ball();
  ExportRequest request;
  request.shells = 5;
  const BakedShells baked = bake_shells(model.view(), strands_of(model), request).value();
  const GlbFile file(baked.glb);
  const auto& primitives = file.json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 6u);
  EXPECT_EQ(file.json["images"].size(), 5u);
  EXPECT_EQ(file.json["materials"].size(), 6u);
  std::size_t triangles = 0;
  for (const auto& primitive : primitives)
    triangles += file.json["accessors"][primitive["indices"].get<std::size_t>()]["count"].get<std::size_t>() / 3;
  EXPECT_EQ(triangles, baked.triangles);
}

TEST(BakedShells, OfSeveralCoatsFollowFromTheSkinOutwards) {
  const FurredModel model = maned(furred_ball(), 0.1f);
  ExportRequest request;
  request.shells = 3;
  const BakedShells baked = bake_shells(model.view(), strands_of(model), request).value();
  const GlbFile file(baked.glb);
  const auto& primitives = file.json["meshes"][0]["primitives"];
  ASSERT_EQ(primitives.size(), 7u);
  std::vector<std::string> names;
  for (const auto& primitive : primitives)
    names.push_back(file.json["materials"][primitive["material"].get<std::size_t>()]["name"]);
  EXPECT_EQ(names, (std::vector<std::string>{"skin", "fur 1", "mane 1", "fur 2", "fur 3", "mane 2", "mane 3"}));
  const auto accessor = [&](std::size_t primitive, const auto& which) {
    return file.json["accessors"][which(primitives[primitive]).template get<std::size_t>()];
  };
  const auto triangles = [](const auto& primitive) { return primitive["indices"]; };
  const auto points = [](const auto& primitive) { return primitive["attributes"]["POSITION"]; };
  EXPECT_LT(accessor(6, triangles)["count"], 0.6 * accessor(4, triangles)["count"].get<double>()) << "on one side";
  EXPECT_GT(accessor(6, points)["max"][0], accessor(4, points)["max"][0]) << "longer";
}

TEST(BakedShells, LieFurtherOutFromRootToTip) {
  const FurredModel model = furred_ball();
  double before = 0;
  for (const double s : {0.0, 0.25, 0.5, 1.0}) {
    double distance = 0;
    const std::vector<glm::vec3> positions = positions_at(model.view(), s);
    for (const glm::vec3& position : positions)
      distance += static_cast<double>(glm::length(position)) / static_cast<double>(positions.size());
    EXPECT_GT(distance, before);
    before = distance;
  }
  const Mesh& mesh = model.model.surface.mesh();
  EXPECT_LT(before, (0.5 / std::sqrt(3.0) + 0.05) * mesh.size);
}

TEST(BakedShells, WithoutFurOnlyTheSkinIsLeft) {
  FurredModel model = furred_ball();
  for (std::uint32_t v = 0; v < model.fields.size(); ++v) model.fields.set(Field::length, v, glm::vec4(0));
  const BakedShells baked = bake_shells(model.view(), strands_of(model), {}).value();
  EXPECT_EQ(GlbFile(baked.glb).json["meshes"][0]["primitives"].size(), 1u);
  EXPECT_EQ(baked.triangles, model.model.surface.mesh().triangles.size());
}

TEST(VertexColours, AreThoseOfTheStrandsAround) {
  FurredModel model = furred_ball();
  const Mesh& mesh = model.model.surface.mesh();
  for (std::uint32_t v = 0; v < model.fields.size(); ++v) {
    const glm::vec4 paint = mesh.positions[v].x > 0 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0, 0, 1, 1);
    model.fields.set(Field::root_colour, v, paint), model.fields.set(Field::tip_colour, v, paint);
  }
  const VertexColours colours(model.model.surface, strands_of(model), 0);
  for (std::uint32_t v = 0; v < model.fields.size(); ++v) {
    const glm::vec3 colour = colours.at(v, 0.6);
    const float side = mesh.positions[v].x;
    if (std::abs(side) < 0.1f) continue;
    EXPECT_GT(side > 0 ? colour.r : colour.b, 2 * (side > 0 ? colour.b : colour.r)) << v;
  }
}

TEST(MeshOfFields, HasAnAttributeForEachField) {
  const FurredModel model = furred_ball();
  const MeshFile mesh = export_mesh(model.view(), strands_of(model)).value();
  const GlbFile file(mesh.glb);
  const auto& attributes = file.json["meshes"][0]["primitives"][0]["attributes"];
  for (const char* name :
       {"POSITION", "NORMAL", "TEXCOORD_0", "COLOR_0", "_DIRECTION", "_LENGTH", "_DENSITY", "_MASK", "_WEIGHT"})
    EXPECT_TRUE(attributes.contains(name)) << name;
  const auto count = [&](const char* name) {
    return file.json["accessors"][attributes[name].get<std::size_t>()]["count"];
  };
  EXPECT_EQ(count("_LENGTH"), count("POSITION"));
}

}  // namespace
}  // namespace pelage::testing
