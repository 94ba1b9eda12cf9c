// Guide curves from files, and the keys that they become.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "base/lean_curve.h"
#include "server/builtin/builtin.h"
#include "server/guide_files/read_guides.h"
#include "server/guides/guide_keys.h"
#include "server/surface/prepare.h"

namespace pelage::guides_test {
namespace {

void expect_near(glm::dvec3 a, glm::dvec3 b) {
  EXPECT_LT(glm::distance(a, b), 1e-6) << a.x << ' ' << a.y << ' ' << a.z;
}

std::string refusal(GuideFormat format, std::string_view bytes) {
  const auto file = read_guides(format, bytes);
  return file ? "" : file.status().message;
}

constexpr const char* usda = R"(#usda 1.0
(
    defaultPrim = "groom"
    customLayerData = { string note = "def Xform \"no\" {" }
)
def Xform "groom" ( prepend apiSchemas = ["GroomAPI"] )
{
    double3 xformOp:translate = (10, 0, 0)
    float xformOp:rotateZ = 90
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateZ"]
    rel material:binding = </materials/fur>  # a comment with { in it
    def Mesh "skin" { point3f[] points = [(7, 7, 7)] int[] faceVertexCounts = [] }
    def BasisCurves "fur" {
        uniform token type = "linear"
        int[] curveVertexCounts = [2, 3]
        point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 2, 0), (0, 3, .5)] ( interpolation = "vertex" )
        float[] widths = [0.1]
    }
})";

TEST(Guides, OfUsdStandWhereTheirXformsPutThem) {
  const auto file = read_guides(GuideFormat::usda, usda);
  ASSERT_TRUE(file.ok()) << file.status().message;
  ASSERT_EQ(file->curves.size(), 2u);
  ASSERT_EQ(file->curves[0].size(), 2u);
  ASSERT_EQ(file->curves[1].size(), 3u);
  expect_near(file->curves[0][1], {10, 1, 0});
  expect_near(file->curves[1][2], {7, 0, 0.5});
}

TEST(Guides, UsdSaysItsAxisAndUnit) {
  const std::string curve =
      "def BasisCurves \"c\" { int[] curveVertexCounts = [2] point3f[] points = [(0, 0, 0), (0, 0, 1)] }";
  const auto read = [&](const std::string& metadata) {
    return read_guides(GuideFormat::usda, "#usda 1.0\n(" + metadata + ")\n" + curve);
  };
  const auto said = read("metersPerUnit = 0.01\n customLayerData = { double metersPerUnit = 7 }\n upAxis = \"Z\"");
  ASSERT_TRUE(said.ok()) << said.status().message;
  EXPECT_EQ(said->up, Axis::plus_z);
  EXPECT_EQ(said->metres, 0.01);
  EXPECT_EQ(read("upAxis = \"Y\"")->up, Axis::plus_y);
  const auto silent = read("doc = \"upAxis = Z\"");
  ASSERT_TRUE(silent.ok()) << silent.status().message;
  EXPECT_FALSE(silent->up || silent->metres);
  for (const char* bad : {"upAxis = \"X\"", "metersPerUnit = 0", "metersPerUnit = -1", "metersPerUnit = 1e300",
                          "metersPerUnit = (1, 2)", "upAxis ="})
    EXPECT_FALSE(read(bad).ok()) << bad;
}

TEST(Guides, MatricesOfUsdAreRows) {
  const auto file = read_guides(GuideFormat::usda, R"(#usda 1.0
def BasisCurves "c" {
  matrix4d xformOp:transform = ( (0, 2, 0, 0), (-2, 0, 0, 0), (0, 0, 2, 0), (5, 6, 7, 1) )
  uniform token[] xformOpOrder = ["xformOp:transform"]
  int[] curveVertexCounts = [2]
  point3f[] points = [(0, 0, 0), (1, 0, 0)]
})");
  ASSERT_TRUE(file.ok()) << file.status().message;
  expect_near(file->curves[0][0], {5, 6, 7});
  expect_near(file->curves[0][1], {5, 8, 7});
}

TEST(Guides, RefusalsOfUsdSayWhy) {
  const auto curves_with = [](const std::string& body) {
    return "#usda 1.0\ndef BasisCurves \"c\" {\n" + body + "\n}";
  };
  EXPECT_NE(refusal(GuideFormat::usda, "PXR-USDC").find("usdcat"), std::string::npos);
  EXPECT_NE(refusal(GuideFormat::usda, "#usda 1.0\n").find("no curves"), std::string::npos);
  EXPECT_NE(refusal(GuideFormat::usda, curves_with("point3f[] points.timeSamples = { 1: [] }")).find("one frame"),
            std::string::npos);
  EXPECT_NE(refusal(GuideFormat::usda, curves_with("int[] curveVertexCounts = [3]\npoint3f[] points = [(0, 0, 0)]"))
                .find("do not fit"),
            std::string::npos);
  EXPECT_NE(refusal(GuideFormat::usda, curves_with("point3f[] points = [(0, 0, x)]")).find("\"x\""), std::string::npos);
  EXPECT_NE(refusal(GuideFormat::usda, curves_with("point3f[] points = [(0, 0,")).find("cut off"), std::string::npos);
  EXPECT_NE(
      refusal(GuideFormat::usda, curves_with("quatf xformOp:orient = (1, 0, 0, 0)\nuniform token[] xformOpOrder = "
                                             "[\"xformOp:orient\"]\nint[] curveVertexCounts = []"))
          .find("xformOp:orient"),
      std::string::npos);
  EXPECT_NE(refusal(GuideFormat::usda,
                    curves_with("int[] curveVertexCounts = [2]\npoint3f[] points = [(0, 0, 0), (0, 0, inf)]"))
                .find("finite"),
            std::string::npos);
  std::string deep = "#usda 1.0\n";
  for (int i = 0; i < 100'000; ++i) deep += "def \"a\" {";
  EXPECT_NE(refusal(GuideFormat::usda, deep).find("deep"), std::string::npos);
}

TEST(Guides, FilesThatAreCutOffAreRefused) {
  const std::string whole = usda;
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refusal(GuideFormat::usda, whole.substr(0, size)), "") << size;
}

template <class T>
void put(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string hair_file(std::uint32_t arrays) {
  std::string bytes = "HAIR";
  for (const std::uint32_t number : {2u, 5u, arrays, 1u}) put(bytes, number);
  bytes.resize(128);
  if ((arrays & 1) != 0) put(bytes, std::uint16_t{1}), put(bytes, std::uint16_t{2});
  for (int i = 0; i < 15; ++i) put(bytes, static_cast<float>(i));
  return bytes;
}

TEST(Guides, HairFilesAreRead) {
  const auto file = read_guides(GuideFormat::hair, hair_file(1 | 2));
  ASSERT_TRUE(file.ok()) << file.status().message;
  ASSERT_EQ(file->curves.size(), 2u);
  EXPECT_EQ(file->curves[0].size(), 2u);
  EXPECT_EQ(file->curves[1].size(), 3u);
  expect_near(file->curves[1][0], {6, 7, 8});
  const auto even = read_guides(GuideFormat::hair, hair_file(2));
  ASSERT_TRUE(even.ok());
  EXPECT_EQ(even->curves[1].size(), 2u);
  EXPECT_NE(refusal(GuideFormat::hair, hair_file(2).substr(0, 20)).find("cut off"), std::string::npos);
  const std::string whole = hair_file(1 | 2);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_NE(refusal(GuideFormat::hair, whole.substr(0, size)), "") << size;
  EXPECT_NE(refusal(GuideFormat::hair, hair_file(1)).find("no points"), std::string::npos);
}

TEST(Guides, JsonIsReadOrRefusedWithTheReason) {
  const auto file = read_guides(GuideFormat::json, R"({"curves": [[[0, 0, 0], [1, 2, 3]]]})");
  ASSERT_TRUE(file.ok());
  expect_near(file->curves[0][1], {1, 2, 3});
  EXPECT_NE(refusal(GuideFormat::json, R"({"curves": [[[0, 0, 0]]]})").find("fewer than two"), std::string::npos);
  const auto some = read_guides(GuideFormat::json, R"({"curves": [[[0, 0, 0]], [[0, 0, 0], [1, 2, 3]], []]})");
  ASSERT_TRUE(some.ok()) << some.status().message;
  EXPECT_EQ(some->curves.size(), 1u);
  EXPECT_EQ(some->single, 2u);
  EXPECT_NE(refusal(GuideFormat::json, R"({"curves": [[[0, 0], [1, 2, 3]]]})").find("three numbers"),
            std::string::npos);
  EXPECT_NE(refusal(GuideFormat::json, "[]").find("curves"), std::string::npos);
}

Surface ball() { return Surface(prepare(make_builtin({Builtin::sphere, 2000})).value()); }

/// A curve drawn along a coat's strand becomes the key that the strand was made from.
TEST(GuideKeys, HaveTheLeanOfTheStrand) {
  const Surface surface = ball();
  const Mesh& mesh = surface.mesh();
  for (const LeanCurve form : {LeanCurve::arc, LeanCurve::root}) {
    Coat coat;
    coat.lean_curve = form;
    for (const double inclination : {0.0, 0.2, 0.7, 0.98}) {
      const SurfacePoint root = surface.nearest({0.1, 0.2, 1});
      const glm::dvec3 normal = surface.normal(root), along = glm::normalize(glm::cross(normal, {0, 1, 0}));
      GuideCurve curve;
      for (int i = 0; i <= 200; ++i) {
        const LeanPoint at = lean_point(form, inclination, coat.root_share, i / 200.0);
        curve.push_back(mesh.to_model(surface.position(root) + 0.04 * (at.across * along + at.up * normal)));
      }
      const GuideKeys found = keys_of({curve}, surface, coat);
      ASSERT_EQ(found.keys.size(), 1u);
      const Key& key = found.keys.front();
      EXPECT_NEAR(*key.inclination, inclination, 1e-3);
      EXPECT_NEAR(*key.length, 0.04, 1e-4);
      if (inclination > 0) {
        EXPECT_NEAR(glm::dot(*key.direction, along), 1, 1e-6);
      }
    }
  }
}

TEST(GuideKeys, LeaveOutWhatStandsElsewhere) {
  const Surface surface = ball();
  const GuideCurve away{{9, 9, 9}, {9, 9, 10}}, on{{0, 0, surface.mesh().to_model({0, 0, 0.3}).z}, {0, 0, 9}};
  const GuideKeys found = keys_of({away, on, away}, surface, {});
  EXPECT_EQ(found.far, 2u);
  EXPECT_EQ(found.keys.size(), 1u);
}

TEST(GuideKeys, AreThinnedEvenly) {
  std::vector<Key> keys(10);
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i].length = static_cast<double>(i);
  const std::vector<Key> kept = thinned(keys, 4);
  ASSERT_EQ(kept.size(), 4u);
  EXPECT_EQ(*kept[0].length, 0);
  EXPECT_EQ(*kept[3].length, 7);
  EXPECT_EQ(thinned(keys, 99).size(), 10u);
}

}  // namespace
}  // namespace pelage::guides_test
