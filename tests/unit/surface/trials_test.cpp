// Small files that once failed, one for each kind of failure: shared/trials and its README.md.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <numeric>

#include "tests/unit/surface/shapes.h"
#include "tests/unit/surface/shared_models.h"

namespace pelage::trials_test {
namespace {

class Trials : public ::testing::Test {
 protected:
  void SetUp() override {
    if (folder().empty()) GTEST_SKIP() << "shared/trials is not there";
  }

  static std::string folder() {
    const auto path = std::filesystem::path(shared_models::folder()).parent_path() / "trials";
    return std::filesystem::exists(path) ? path.string() : "";
  }

  static Mesh load(const std::string& file) {
    Result<Mesh> mesh = shared_models::load_file(folder() + "/" + file);
    EXPECT_TRUE(mesh.ok()) << file << ": " << (mesh.ok() ? "" : mesh.status().message);
    return mesh.ok() ? std::move(*mesh) : Mesh();
  }
};

Repair repair_of(const Mesh& mesh, const std::string& code) {
  for (const Repair& repair : mesh.report.repairs)
    if (repair.code == code) return repair;
  return {code, 0};
}

TEST_F(Trials, ATextureTransformMovesTheTexture) {
  const Mesh mesh = load("tt0.glb");
  ASSERT_EQ(mesh.images.size(), 1u);
  const RawImage& image = mesh.images.front();
  for (const auto& triangle : mesh.corners) {
    const glm::vec2 uv = (triangle[0].uv + triangle[1].uv + triangle[2].uv) / 3.0f;
    const int x = static_cast<int>((uv.x - std::floor(uv.x)) * static_cast<float>(image.width)),
              y = static_cast<int>((std::ceil(uv.y) - uv.y) * static_cast<float>(image.height));
    const std::uint8_t* pixel = &image.rgba[static_cast<std::size_t>(4 * (y * image.width + x))];
    ASSERT_TRUE(pixel[0] > 200 && pixel[1] > 200 && pixel[2] < 50) << "yellow all over, at " << uv.x << " " << uv.y;
  }
}

TEST_F(Trials, InstancesBecomeParts) {
  const Mesh mesh = load("gpui.glb");
  EXPECT_EQ(mesh.report.parts, 3u);
  EXPECT_EQ(mesh.report.triangles, 3 * 2208u);
  EXPECT_EQ(repair_of(mesh, "ignored_extensions").count, 0u);
}

TEST_F(Trials, PicturesThatOnlyAnExtensionNamesAreMissing) {
  for (const auto& [file, extension] :
       {std::pair("webponly.glb", "EXT_texture_webp"), std::pair("ktxonly.glb", "KHR_texture_basisu")}) {
    const Repair missing = repair_of(load(file), "missing_pictures");
    EXPECT_EQ(missing.count, 1u) << file;
    ASSERT_EQ(missing.names.size(), 1u) << file;
    EXPECT_NE(missing.names.front().find(extension), std::string::npos) << missing.names.front();
  }
}

TEST_F(Trials, ABadIndexDropsItsFaceAndIsReported) {
  const Mesh mesh = load("badindex.glb");
  EXPECT_EQ(repair_of(mesh, "bad_indices").count, 1u);
  EXPECT_EQ(mesh.report.source_faces, 2208u);
  EXPECT_EQ(mesh.report.triangles, 2207u);
}

TEST_F(Trials, QuantizedPositionsAreRead) {
  const Mesh mesh = load("quant1.glb");
  EXPECT_EQ(mesh.report.triangles, 2208u);
  for (const glm::vec3& p : mesh.positions) ASSERT_NEAR(glm::length(p), 0.5 / std::sqrt(3.0), 1e-4);
}

TEST_F(Trials, FurGrowsOutwardsWhereJointsMirror) {
  for (const char* file : {"bone_negx.glb", "mirjoint_open.glb", "mirjoint_closed.glb"}) {
    const Mesh mesh = load(file);
    EXPECT_EQ(repair_of(mesh, "mirrored_joints").count, 1u) << file;
    std::vector<std::uint32_t> part(mesh.positions.size());
    std::iota(part.begin(), part.end(), 0u);
    const auto root = [&](std::uint32_t v) {
      while (part[v] != v) v = part[v] = part[part[v]];
      return v;
    };
    for (const glm::uvec3& t : mesh.triangles) part[root(t.y)] = root(t.x), part[root(t.z)] = root(t.x);
    std::map<std::uint32_t, std::pair<glm::dvec3, double>> sums;
    for (std::uint32_t v = 0; v < part.size(); ++v)
      sums[root(v)].first += glm::dvec3(mesh.positions[v]), sums[root(v)].second += 1;
    std::map<std::uint32_t, double> volumes;
    for (const glm::uvec3& t : mesh.triangles) {
      const auto& of_part = sums[root(t.x)];
      const glm::dvec3 middle = of_part.first / of_part.second;
      const auto at = [&](int k) { return glm::dvec3(mesh.positions[t[k]]) - middle; };
      volumes[root(t.x)] += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
    }
    EXPECT_EQ(volumes.size(), 2u) << file;
    for (const auto& [number, volume] : volumes) EXPECT_GT(volume, 0) << file;
  }
}

TEST_F(Trials, UnusableTextureCoordinatesAreReported) {
  EXPECT_GT(repair_of(load("uv_huge.obj"), "unusable_uvs").count, 2000u);
  const std::size_t some = repair_of(load("uv_nan.obj"), "unusable_uvs").count;
  EXPECT_GT(some, 0u);
  EXPECT_LE(some, 2208u);
}

}  // namespace
}  // namespace pelage::trials_test
