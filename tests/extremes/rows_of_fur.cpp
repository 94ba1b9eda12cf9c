// Rows of fur and of scattering.
#include <array>

#include "tests/extremes/row.h"

namespace pelage::testing {

namespace {

std::string ball(const std::string& fur) {
  return R"({"model": {"builtin": "sphere", "triangles": 300}, "fur": {)" + fur + "}}";
}

Row of_fur(std::string value, std::vector<std::string> commands, std::string refused = {}) {
  return {.area = "fur", .value = std::move(value), .commands = std::move(commands), .refused = std::move(refused)};
}

Row of_length(const std::string& length, std::string refused = {}) {
  return {.area = "fur",
          .value = "length " + length + " sizes",
          .scene = ball(R"("length": )" + length),
          .refused = std::move(refused)};
}

Row of_quality(std::string value, const std::string& quality, std::string refused = {}) {
  return {.area = "fur",
          .value = std::move(value),
          .frame = R"({"width": 16, "height": 12, "quality": {)" + quality + "}}",
          .refused = std::move(refused)};
}

std::string coat(const std::string& members) { return R"({"op": "set_coat", "coat": {)" + members + "}}"; }

std::string paint(const std::string& field, const std::string& value) {
  return R"({"op": "paint", "flood": true, "brush": {"strength": 1}, "field": ")" + field + R"(", "value": )" + value +
         "}";
}

std::string flood_comb(const std::string& direction, const std::string& more = "") {
  return R"({"op": "comb", "flood": true, "lean": 1, "brush": {"strength": 1}, "direction": )" + direction + more + "}";
}

/// Looks along -z, so that a light along -z shines with the view, along +z against it.
Row of_scattering(const std::string& model, const std::string& value, const std::string& look,
                  const std::string& towards = "[0, 0, -1]") {
  return {.area = "scattering",
          .value = model + ": " + value,
          .commands = {R"({"op": "set_look", "look": {"shading": ")" + model + "\"" + look + "}}",
                       R"({"op": "set_lights", "lights": [{"direction": )" + towards + R"(, "intensity": 10}]})",
                       flood_comb("[0, 1, 0]")},
          .frame = R"({"width": 16, "height": 12, "camera": {"auto": "front"}})"};
}

constexpr std::array models{"lengyel", "kajiya", "energy_conserving", "scheuermann", "kajiya_kay", "marschner"};

void add_model(Rows& rows, const std::string& model) {
  rows.push_back(of_scattering(model, "lit along the view", ""));
  rows.push_back(of_scattering(model, "lit against the view", "", "[0, 0, 1]"));
  rows.push_back(of_scattering(model, "lit along the strands", "", "[0, -1, 0]"));
  for (const char* exponent : {"0", "1e6"}) {
    const std::string all = std::string(R"("specular_exponent": )") + exponent + R"(, "diffuse_exponent": )" + exponent;
    rows.push_back(of_scattering(model, std::string("exponents ") + exponent,
                                 ", " + all + R"(, "specular": 4, "fibre": {"secondary_exponent": )" + exponent + "}"));
  }
}

void add_fibre(Rows& rows, const std::string& model) {
  for (const char* roughness : {"0", "1e-4", "1"}) {
    const std::string both =
        std::string(R"("longitudinal_roughness": )") + roughness + R"(, "azimuthal_roughness": )" + roughness;
    for (const char* eta : {"1", "1.000001", "3"}) {
      rows.push_back(of_scattering(model, std::string("roughness ") + roughness + ", eta " + eta,
                                   R"(, "fibre": {)" + both + R"(, "refractive_index": )" + eta + "}"));
    }
  }
  for (const char* pigment : {"0", "1e4"}) {
    rows.push_back(of_scattering(model, std::string("pigment ") + pigment,
                                 std::string(R"(, "fibre": {"absorption": "melanin", "eumelanin": )") + pigment +
                                     R"(, "pheomelanin": )" + pigment + "}"));
  }
  rows.push_back(of_scattering(model, "lobes of no width, lit against the view",
                               R"(, "fibre": {"highlight_width": 0, "caustic_width": 1, "cuticle_tilt": -15})",
                               "[0, 0, 1]"));
}

}  // namespace

Rows fur_rows() {
  Rows rows{of_length("0"),
            of_length("1e-6"),
            of_length("10"),
            of_length("10.1", "/fur/length"),
            of_length("-1", "/fur/length"),
            of_fur("density 0", {paint("density", "0")}),
            of_fur("density 1", {paint("density", "1")}),
            of_fur("density 1.5", {paint("density", "1.5")}, "/value"),
            of_fur("all fields at their most",
                   {paint("width", "4"), paint("curl", "1"), paint("clump", "1"), paint("wetness", "1")}),
            of_fur("width 0", {paint("width", "0")}),
            of_fur("bare", {paint("bare", "1")}),
            of_fur("1 strand", {coat(R"("count": 1, "tile": 1)")}),
            of_fur("100,000 strands in a tile of 0.01", {coat(R"("count": 100000, "tile": 0.01)")}),
            of_fur("100,001 strands", {coat(R"("count": 100001)")}, "/coat/count"),
            of_fur("strands of no width", {coat(R"("width_root": 0, "width_tip": 0)")}),
            of_fur("strands as wide as can be", {coat(R"("width_root": 0.05, "width_tip": 0.05)")}),
            of_fur("all forms at their most",
                   {coat(R"("bend": 2, "curl": 0.5, "curl_turns": 20, "curl_together": 1, "wave": 0.5, "wave_turns": 20,
                            "mess": 1, "clump": 1, "fine_clump": 1, "lodge": 1, "wetness": 1, "length_spread": 1,
                            "colour_spread": 1, "root_share": 1, "tufts": {"gather": 1, "size": 0.01, "scales": 3})")}),
            of_fur("all spread at its most",
                   {coat(R"("length_spread": 1, "undercoat": {"share": 1, "length": 0.02, "width": 4, "lightness": 4},
                            "ticking": {"share": 1}, "variation": {"lightness": 1, "hue": 1, "length": 1, "lean": 1,
                            "size": 0.005}, "pattern": {"kind": "rosettes", "scale": 0.005, "warp": 2, "softness": 0})")})};
  for (const char* shells : {"1", "2", "1024"}) {
    rows.push_back(of_quality(std::string(shells) + " shells",
                              std::string(R"("method": "shells", "shells": {"count": )") + shells + "}"));
  }
  for (const char* strands : {"0.01", "1000"}) {
    rows.push_back(of_quality(std::string(strands) + " strands a pixel",
                              std::string(R"("raster": {"strands": )") + strands + "}"));
  }
  rows.push_back(of_quality("0 shells", R"("method": "shells", "shells": {"count": 0})", "/quality/shells/count"));
  rows.push_back(
      of_quality("1,025 shells", R"("method": "shells", "shells": {"count": 1025})", "/quality/shells/count"));
  for (const char* direction : {"[0, 1, 0]", "[0, -1, 0]"}) {
    rows.push_back(of_fur(std::string("combed towards ") + direction + ", along or against the normal at the poles",
                          {flood_comb(direction)}));
  }
  rows.push_back(of_fur("strokes that cancel",
                        {flood_comb("[1, 0, 0]"), flood_comb("[-1, 0, 0]", R"(, "brush": {"strength": 0.5})")}));
  rows.back().commands[1] =
      R"({"op": "comb", "flood": true, "lean": 1, "brush": {"strength": 0.5}, "direction": [-1, 0, 0]})";
  rows.push_back(of_fur("combed towards nowhere", {flood_comb("[0, 0, 0]")}, "/direction"));
  for (const char* lean : {"0", "1"})
    rows.push_back({.area = "fur",
                    .value = std::string("inclination ") + lean + ", length 10",
                    .scene = ball(std::string(R"("length": 10, "inclination": )") + lean)});
  return rows;
}

Rows scattering_rows() {
  Rows rows;
  for (const char* model : models) add_model(rows, model);
  add_fibre(rows, "energy_conserving");
  add_fibre(rows, "marschner");
  const auto refused = [&](const char* value, const std::string& look, const char* pointer) {
    rows.push_back({.area = "scattering",
                    .value = value,
                    .commands = {R"({"op": "set_look", "look": {)" + look + "}}"},
                    .refused = pointer});
  };
  refused("roughness below 0", R"("fibre": {"longitudinal_roughness": -1e-9})", "/look/fibre/longitudinal_roughness");
  refused("eta below 1", R"("fibre": {"refractive_index": 0.999})", "/look/fibre/refractive_index");
  refused("pigment over 1e4", R"("fibre": {"eumelanin": 10001})", "/look/fibre/eumelanin");
  refused("exponent over 1e6", R"("specular_exponent": 1000001)", "/look/specular_exponent");
  return rows;
}

}  // namespace pelage::testing
