#include <algorithm>

#include "server/export/buffered.h"
#include "server/export/strand_files.h"

namespace pelage {

namespace {

/// Calls use(set, group) for each set until the sink ends it; group 0 is fur, 1 curves.
template <class Use>
void for_each_set(const ExportedStrands& strands, const Buffered& out, const Use& use) {
  const std::size_t fur = strands.sets.size() - strands.curve_sets;
  for (std::size_t k = 0; k < strands.sets.size() && out.going(); ++k) use(strands.sets[k], k < fur ? 0 : 1);
}

/// An array with `print(separator, set, i)` for each point, or for each strand, of all sets.
template <class Print>
void write_array(const ExportedStrands& strands, Buffered& out, std::string_view declaration, bool of_points,
                 const char* interpolation, const Print& print) {
  out.print("        {} = [", declaration);
  const char* separator = "";
  for_each_set(strands, out, [&](const StrandSet& set, int group) {
    const std::size_t count = of_points ? set.points.size() : set.count();
    for (std::size_t i = 0; i < count; ++i) {
      out.print("{}", separator);
      print(set, i, group);
      separator = ", ";
    }
  });
  out.print("]");
  if (interpolation) out.print(" (\n            interpolation = \"{}\"\n        )", interpolation);
  out.print("\n");
}

void print_vector(Buffered& out, glm::vec3 v) { out.print("({}, {}, {})", v.x, v.y, v.z); }

void write_extent(const ExportedStrands& strands, Buffered& out) {
  glm::vec3 low(0), high(0);
  bool any = false;
  for_each_set(strands, out, [&](const StrandSet& set, int) {
    for (const StrandPoint& point : set.points) {
      const glm::vec3 place = strands.model_offset(point), half(strands.model_width(point) / 2);
      low = any ? glm::min(low, place - half) : place - half;
      high = any ? glm::max(high, place + half) : place + half;
      any = true;
    }
  });
  out.print("        float3[] extent = [");
  print_vector(out, low), out.print(", "), print_vector(out, high);
  out.print("]\n");
}

void write_points(const ExportedStrands& strands, Buffered& out) {
  write_array(strands, out, "int[] curveVertexCounts", false, nullptr,
              [&](const StrandSet& set, std::size_t, int) { out.print("{}", set.segments + 1); });
  write_array(strands, out, "point3f[] points", true, nullptr, [&](const StrandSet& set, std::size_t i, int) {
    print_vector(out, strands.model_offset(set.points[i]));
  });
  write_array(strands, out, "float[] widths", true, "vertex",
              [&](const StrandSet& set, std::size_t i, int) { out.print("{}", strands.model_width(set.points[i])); });
  for (const char* name : {"color3f[] primvars:displayColor", "float3[] primvars:groom_color"}) {
    write_array(strands, out, name, true, "vertex",
                [&](const StrandSet& set, std::size_t i, int) { print_vector(out, unpack_colour(set.colours[i])); });
  }
}

void write_root_uvs(const ExportedStrands& strands, Buffered& out) {
  if (strands.root_uvs.empty()) return;
  for (const char* name : {"texCoord2f[] primvars:st", "float2[] primvars:groom_root_uv"}) {
    std::size_t strand = 0;
    write_array(strands, out, name, false, "uniform", [&](const StrandSet&, std::size_t, int) {
      const glm::vec2 uv = strands.root_uvs[strand++];
      out.print("({}, {})", uv.x, uv.y);
    });
  }
}

void write_groom_names(const ExportedStrands& strands, bool as_guides, Buffered& out) {
  std::size_t strand = 0;
  write_array(strands, out, "int[] primvars:groom_id", false, "uniform",
              [&](const StrandSet&, std::size_t, int) { out.print("{}", strand++); });
  write_array(strands, out, "int[] primvars:groom_group_id", false, "uniform",
              [&](const StrandSet&, std::size_t, int group) { out.print("{}", group); });
  out.print("        int[] primvars:groom_guide = [{}] (\n            interpolation = \"constant\"\n        )\n",
            as_guides ? 1 : 0);
}

}  // namespace

bool write_usda(const ExportedStrands& strands, const ExportAnswer& about, bool as_guides, const Sink& sink) {
  Buffered out(sink);
  out.print(
      "#usda 1.0\n(\n    customLayerData = {{\n        string generator = \"Pelage\"\n        int revision = {}\n",
      about.revision);
  out.print("    }}\n    defaultPrim = \"groom\"\n    metersPerUnit = 1\n    upAxis = \"Y\"\n)\n\n");
  out.print(
      "def Xform \"groom\" (\n    prepend apiSchemas = [\"GroomAPI\"]\n)\n{{\n    double3 xformOp:translate = ({}, {}, "
      "{})\n",
      strands.centre.x, strands.centre.y, strands.centre.z);
  out.print("    uniform token[] xformOpOrder = [\"xformOp:translate\"]\n\n    def BasisCurves \"fur\"\n    {{\n");
  out.print("        uniform token type = \"linear\"\n        uniform token wrap = \"nonperiodic\"\n");
  write_extent(strands, out);
  write_points(strands, out);
  write_root_uvs(strands, out);
  write_groom_names(strands, as_guides, out);
  out.print("    }}\n}}\n");
  return out.finish();
}

}  // namespace pelage
