// Tests every file of the shared folder against the tables of its README.
#include "tests/unit/surface/shared_models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>

#include "tests/unit/surface/mesh_checks.h"

namespace pelage::shared_models_test {
namespace {

using shared_models::Row;

class SharedModels : public testing::Test {
 protected:
  void SetUp() override {
    if (!shared_models::folder().empty()) return;
    const char* ci = std::getenv("CI");
    if (ci && std::string(ci) == "true") FAIL() << "shared/meshes is missing";
    GTEST_SKIP() << "shared/meshes is missing";
  }
};

struct Counts {
  std::size_t vertices = 0, faces = 0;
};

Counts counts_of(const std::string& cell) {
  Counts counts;
  std::sscanf(cell.c_str(), "%zu / %zu", &counts.vertices, &counts.faces);
  return counts;
}

std::string describe(const ModelReport& report) {
  std::string text = std::to_string(report.source_vertices) + " -> " + std::to_string(report.vertices) + " vertices, " +
                     std::to_string(report.source_faces) + " faces -> " + std::to_string(report.triangles) +
                     " triangles, " + std::to_string(report.parts) + " parts, size " + std::to_string(report.size);
  for (const Repair& repair : report.repairs) text += ", " + repair.code + " " + std::to_string(repair.count);
  return text;
}

TEST_F(SharedModels, EveryModelLoadsWithItsCounts) {
  std::size_t models = 0;
  for (const Row& row : shared_models::table("Models")) {
    const std::string file = row.at("file");
    if (!shared_models::format_of(file)) continue;
    SCOPED_TRACE(file);
    const Result<Mesh> mesh = shared_models::load_file(shared_models::folder() + "/" + file);
    ASSERT_TRUE(mesh.ok()) << mesh.status().message;
    expect_groomable(*mesh);
    const ModelReport& report = mesh->report;
    const Counts expected = counts_of(row.at("vertices / faces"));
    EXPECT_TRUE(report.vertices == expected.vertices || report.source_vertices == expected.vertices);
    EXPECT_EQ(report.source_faces, expected.faces);
    EXPECT_GE(report.triangles, expected.faces);
    std::cout << file << ": " << describe(report) << "\n";
    ++models;
  }
  EXPECT_GE(models, 15u);
}

using Corner = std::array<float, 3>;
using Triangle = std::array<Corner, 3>;

/// Triangles with positions rounded to 32 bits; each begins with its smallest corner.
std::vector<Triangle> triangles_of(const RawModel& raw) {
  std::vector<Triangle> triangles;
  std::size_t begin = 0;
  for (std::uint32_t size : raw.face_sizes) {
    Triangle triangle{};
    for (std::size_t k = 0; k < 3 && size == 3; ++k) {
      const glm::vec3 p(raw.positions[raw.corners[begin + k]]);
      triangle[k] = {p.x, p.y, p.z};
    }
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles.push_back(triangle);
    begin += size;
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

TEST_F(SharedModels, PairsNamedAsEqualAreEqual) {
  const auto pairs = shared_models::equal_pairs();
  ASSERT_GE(pairs.size(), 6u);
  for (const auto& [a, b] : pairs) {
    const Result<RawModel> first = shared_models::import_file(shared_models::folder() + "/" + a);
    const Result<RawModel> second = shared_models::import_file(shared_models::folder() + "/" + b);
    ASSERT_TRUE(first.ok() && second.ok()) << a << " " << b;
    const auto x = triangles_of(*first), y = triangles_of(*second);
    EXPECT_EQ(x.size(), y.size()) << a << " " << b;
    EXPECT_TRUE(x == y) << a << " and " << b << " differ";
    std::cout << a << " = " << b << ": " << x.size() << " triangles\n";
  }
}

/// What the column "expected" requires.
enum class Wish { load, reject, either };

Wish wish_of(const std::string& expected) {
  const bool load = expected.starts_with("load"), reject = expected.starts_with("reject");
  const bool either = expected.starts_with("no crash") || expected.find(" or ") != std::string::npos ||
                      expected.find(", or") != std::string::npos || expected.find("(or ") != std::string::npos;
  if (either || (!load && !reject)) return Wish::either;
  return load ? Wish::load : Wish::reject;
}

TEST_F(SharedModels, EveryNastyFileGetsWhatIsExpected) {
  std::size_t loads = 0, rejects = 0, eithers = 0;
  for (const Row& row : shared_models::table("nasty")) {
    const std::string file = row.at("file"), expected = row.at("expected");
    SCOPED_TRACE(file + ": " + expected);
    const Result<Mesh> mesh = shared_models::load_file(shared_models::folder() + "/nasty/" + file);
    const Wish wish = wish_of(expected);
    if (mesh.ok()) {
      expect_groomable(*mesh);
      EXPECT_NE(wish, Wish::reject);
      EXPECT_TRUE(expected.find("warning") == std::string::npos || !mesh->report.repairs.empty());
    } else {
      EXPECT_EQ(mesh.status().code, Code::invalid);
      EXPECT_GT(mesh.status().message.size(), 20u);
      EXPECT_EQ(mesh.status().message.find("crash"), std::string::npos) << mesh.status().message;
      EXPECT_NE(wish, Wish::load) << mesh.status().message;
    }
    (wish == Wish::load ? loads : wish == Wish::reject ? rejects : eithers) += 1;
    std::cout << file << " [" << expected << "] "
              << (mesh.ok() ? "LOADED " + describe(mesh->report) : "REFUSED " + mesh.status().message) << "\n";
  }
  std::cout << "nasty: " << loads << " to load, " << rejects << " to reject, " << eithers << " either\n";
  const std::filesystem::directory_iterator files(shared_models::folder() + "/nasty");
  EXPECT_EQ(loads + rejects + eithers, static_cast<std::size_t>(std::distance(begin(files), end(files))));
}

TEST_F(SharedModels, RefusalsNameWhatIsMissing) {
  const auto message = [](const std::string& file) {
    const Result<RawModel> raw = shared_models::import_file(shared_models::folder() + "/nasty/" + file);
    return raw.ok() ? std::string() : raw.status().message;
  };
  EXPECT_NE(message("Box_Draco.glb").find("KHR_draco_mesh_compression"), std::string::npos);
  EXPECT_NE(message("non_relative_uri.gltf").find("http://example.com/buffer.bin"), std::string::npos);
  EXPECT_NE(message("RecursiveNodes.gltf").find("cycle"), std::string::npos);
  EXPECT_NE(message("box_UTF16BE.obj").find("UTF-16"), std::string::npos);
}

TEST_F(SharedModels, TexturesAndTextureCoordinatesComeAlong) {
  const Result<Mesh> glb = shared_models::load_file(shared_models::folder() + "/spot.glb");
  ASSERT_TRUE(glb.ok());
  ASSERT_EQ(glb->images.size(), 1u);
  EXPECT_EQ(glb->images[0].width, 1024);
  ASSERT_FALSE(glb->corners.empty());
  EXPECT_EQ(glb->corners[0][0].image, 0);
}

/// V points up in both, although glTF stores it downwards.
TEST_F(SharedModels, AShapeIsTheModelWithoutItsPictures) {
  const std::string bytes = shared_models::read_file(shared_models::folder() + "/Fox.glb");
  const auto file = std::as_bytes(std::span(bytes));
  const Result<RawModel> whole = import_model(PELAGE_IMPORT, ModelFormat::glb, file, "Walk@0.2");
  const Result<RawModel> shape = import_shape(PELAGE_IMPORT, ModelFormat::glb, file, "Walk@0.2");
  ASSERT_TRUE(whole.ok() && shape.ok());
  EXPECT_EQ(whole->images.size(), 1u);
  EXPECT_EQ(shape->images.size(), 0u);
  EXPECT_EQ(shape->positions, whole->positions);
}

TEST_F(SharedModels, TextureCoordinatesOfGlbAndObjAgree) {
  const auto centre_of = [](const char* file) {
    const Result<RawModel> raw = shared_models::import_file(shared_models::folder() + "/" + file);
    glm::dvec3 sum(0);
    for (std::size_t i = 0; raw.ok() && i < raw->corners.size(); ++i) {
      // Weighted by height, so that a flipped V would show.
      sum += glm::dvec3(raw->corner_uv[i] * raw->positions[raw->corners[i]].y, 1);
    }
    return sum;
  };
  const glm::dvec3 obj = centre_of("spot.obj"), glb = centre_of("spot.glb");
  ASSERT_GT(obj.z, 0);
  EXPECT_NEAR(obj.x, glb.x, 1e-3 * std::abs(obj.x));
  EXPECT_NEAR(obj.y, glb.y, 1e-3 * std::abs(obj.y));
}

TEST(PackagedModels, HorseAndCatLoad) {
  for (const char* file : {"horse.3ds", "cat.3ds"}) {
    const std::string path = std::string("/usr/share/glmark2/models/") + file;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "glmark2-data is not installed";
    const Result<Mesh> mesh = shared_models::load_file(path);
    ASSERT_TRUE(mesh.ok()) << file << ": " << mesh.status().message;
    expect_groomable(*mesh);
    EXPECT_TRUE(mesh->corners.empty()) << "one grey is no colour of its own";
    // In the files' own coordinates Y is up: the horse rears and is tallest along Y, the cat lies and is longest along
    // X.
    const glm::dvec3 box = mesh->report.bounds.max - mesh->report.bounds.min;
    EXPECT_EQ(box.y > box.x, std::string(file) == "horse.3ds");
    EXPECT_GT(std::min(box.x, box.y), box.z);
    std::cout << file << ": " << describe(mesh->report) << "\n";
  }
}

}  // namespace
}  // namespace pelage::shared_models_test
