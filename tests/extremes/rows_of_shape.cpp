// Rows of the mesh and of the brush.
#include <bit>
#include <cstdint>

#include "tests/extremes/row.h"

namespace pelage::testing {

namespace {

Row of_file(std::string value, std::string bytes, std::string refused = {}) {
  return {.area = "mesh", .value = std::move(value), .model = {std::move(bytes)}, .refused = std::move(refused)};
}

std::string vertex(double x, double y, double z) {
  return "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
}

/// An OBJ of tetrahedra side by side that share no vertices.
std::string tetrahedra(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double x = i % 20, y = i / 20;
    text += vertex(x, y, 0) + vertex(x + 0.7, y, 0) + vertex(x, y + 0.7, 0) + vertex(x, y, 0.7);
    text += "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n";
  }
  return text;
}

/// An OBJ of a cube from `low` to `high` on x and 0 to 1 on y and z; `scale` is an exponent that is appended to each
/// number, e.g. "e-6".
std::string cube(const std::string& scale, double low, double high) {
  const auto at = [&](double x, double y, double z) {
    const auto number = [&](double v) { return v == 0 ? std::string("0") : std::to_string(v) + scale; };
    return "v " + number(x) + " " + number(y) + " " + number(z) + "\n";
  };
  std::string text;
  for (const double x : {low, high})
    for (const double y : {0.0, 1.0})
      for (const double z : {0.0, 1.0}) text += at(x, y, z);
  return text + "f 1 2 4 3\nf 5 7 8 6\nf 1 5 6 2\nf 3 4 8 7\nf 1 3 7 5\nf 2 6 8 4\n";
}

void append(std::string& bytes, std::uint32_t word) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(word >> (8 * k) & 0xffu);
}

/// A binary STL of two triangles, moved along x.
std::string binary_stl(float offset) {
  std::string bytes(80, ' ');
  append(bytes, 2);
  const auto triangle = [&](float a, float b, float c) {
    for (const float v : {0.f, 0.f, 0.f, a, 0.f, 0.f, b, 1.f, 0.f, c, 0.f, 1.f})
      append(bytes, std::bit_cast<std::uint32_t>(v));
    bytes += std::string(2, '\0');
  };
  triangle(offset, offset + 1, offset);
  triangle(offset, offset + 1, offset + 1);
  return bytes;
}

const std::string plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
const std::string apart =
    tetrahedra(1) + "v 30 0 0\nv 31 0 0\nv 30 1 0\nv 30 0 1\nf -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -4 -1 -2\n";

Row of_brush(std::string value, std::string command, std::string refused = {}) {
  return {.area = "brush", .value = std::move(value), .commands = {std::move(command)}, .refused = std::move(refused)};
}

std::string comb(const std::string& brush) {
  return R"({"op": "comb", "brush": {)" + brush +
         R"(}, "stroke": {"samples": [{"position": [-0.3, 0, 1]}, {"position": [0.3, 0.1, 1]}]}})";
}

Row on_two_parts(std::string value, std::string command) {
  Row row = of_brush(std::move(value), std::move(command));
  row.model = {apart};
  return row;
}

}  // namespace

Rows mesh_rows() {
  return {of_file("empty", "o nothing\n", "model"),
          of_file("one triangle", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
          of_file("only a triangle of no area", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "model"),
          of_file("a triangle of no area beside others", plain + "v 2 0 0\nf 1 2 5\n"),
          of_file("sliver of height 1e-12", "v 0 0 0\nv 1 0 0\nv 0.5 1e-12 0\nf 1 2 3\n"),
          {.area = "mesh",
           .value = "sliver of height 1e-12 that covers a pixel's middle",
           .frame = R"({"width": 7, "height": 9, "quality": {"scale": 2}})",
           .model = {"v 0 0 0\nv 1 0 0\nv 0.5 1e-12 0\nf 1 2 3\n"}},
          of_file("sliver of height 1e-12 beside others", plain + "v 0.5 -1e-12 0\nf 1 2 5\n"),
          of_file("three triangles on an edge", plain + "v 0.5 -1 0\nf 1 2 5\n"),
          of_file("two solids that share a vertex",
                  plain + "v -1 0 0\nv 0 -1 0\nv 0 0 -1\nf 1 6 5\nf 1 5 7\nf 1 7 6\nf 5 6 7\n"),
          of_file("a triangle and its twin wound the other way", plain + "f 2 4 3\n"),
          of_file("duplicate and isolated vertices",
                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 9 9 9\nf 1 2 3\nf 4 6 5\n"),
          of_file("200 parts", tetrahedra(200)),
          of_file("only a triangle with a NaN vertex", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "model"),
          of_file("a NaN vertex beside others", plain + "v nan 0 0\nv inf 1 1\nf 1 2 5\nf 2 3 6\n"),
          of_file("scale 1e-6", cube("e-6", 0, 1)),
          of_file("scale 1e6", cube("e6", 0, 1)),
          of_file("coordinates over 1e20", cube("e20", 0, 1.5), "model"),
          of_file("offset 1e3", cube("", 1e3, 1e3 + 1)),
          of_file("offset 1e6", cube("", 1e6, 1e6 + 1)),
          {.area = "mesh", .value = "offset 1e3 in 32-bit floats", .model = {binary_stl(1e3f), ModelFormat::stl}},
          {.area = "mesh",
           .value = "offset 1e6 in 32-bit floats",
           .model = {binary_stl(1e6f), ModelFormat::stl},
           .refused = "model"},
          {.area = "mesh",
           .value = "1 triangle of a built-in",
           .scene = R"({"model": {"builtin": "plane", "triangles": 1}})",
           .refused = "/model/triangles"},
          {.area = "mesh", .value = "2 triangles", .scene = R"({"model": {"builtin": "plane", "triangles": 2}})"},
          {.area = "mesh",
           .value = "a built-in of 1,000,001 triangles",
           .scene = R"({"model": {"builtin": "torus", "triangles": 1000001}})",
           .refused = "/model/triangles"}};
}

Rows brush_rows() {
  const std::string key =
      R"("keys": [{"position": [0, 0, 1], "length": 0.3}, {"position": [0, 0.5, -1], "length": 0.01}])";
  return {
      of_brush("radius 0", comb(R"("radius": 0)")),
      of_brush("radius 1e6 sizes", comb(R"("radius": 1e6, "strength": 1)")),
      of_brush("radius 1e27 of the model's units", comb(R"("radius": 1e27, "units": "world", "strength": 1)"),
               "/brush/radius"),
      of_brush("radius below 0", comb(R"("radius": -1)"), "/brush/radius"),
      of_brush("strength 0", comb(R"("radius": 0.2, "strength": 0)")),
      of_brush("strength 1.1", comb(R"("radius": 0.2, "strength": 1.1)"), "/brush/strength"),
      of_brush("more than 100,000 dabs", comb(R"("radius": 1e-9, "spacing": 0.01)"), "/brush/spacing"),
      of_brush("falloff of two points, 0 and 0", comb(R"("radius": 0.3, "falloff_points": [0, 0])")),
      of_brush("cut-off at 0 degrees", comb(R"("radius": 0.3, "cut_off_degrees": 0)")),
      of_brush("sigma 1e-6", R"({"op": "interpolate", "sigma": 1e-6, )" + key + "}"),
      of_brush("sigma 1e6", R"({"op": "interpolate", "sigma": 1e6, )" + key + "}"),
      of_brush("sigma 0", R"({"op": "interpolate", "sigma": 0, )" + key + "}", "/sigma"),
      on_two_parts("a part that no path reaches: by heat",
                   R"({"op": "interpolate", "distance": "heat", "keys": [{"position": [0, 0, 0], "length": 0.3}]})"),
      on_two_parts(
          "a part that no path reaches: along edges",
          R"({"op": "interpolate", "distance": "dijkstra", "keys": [{"position": [0, 0, 0], "length": 0.3}]})"),
      on_two_parts("a part that no path reaches: brush along the surface",
                   R"({"op": "paint", "field": "density", "value": 0, "brush": {"radius": 100, "strength": 1,
                           "falloff_shape": "surface"}, "stroke": {"samples": [{"position": [0, 0, 0]}]}})"),
      of_brush("attracted from nowhere for 1e4 seconds",
               R"({"op": "attract", "point": [1e6, 0, 0], "radius": 1e6, "strength": 1, "duration": 1e4,
                       "max_stretch": 100, "threshold": 0})"),
      of_brush("blown from inside the skin",
               R"({"op": "blow", "source": [0, 0, 1], "cone_degrees": 180, "strength": 1, "lean": 1})"),
      of_brush("noise of amount 10 and no feature size",
               R"({"op": "noise", "flood": true, "amount": 10, "feature_size": 0})"),
      of_brush("10,000 passes of smoothing", R"({"op": "smooth", "flood": true, "t": 1, "passes": 10000})"),
      of_brush("10,001 passes", R"({"op": "smooth", "flood": true, "passes": 10001})", "/passes")};
}

}  // namespace pelage::testing
