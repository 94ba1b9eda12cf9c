#include <algorithm>
#include <string>
#include <utility>

#include "server/export/buffered.h"
#include "server/export/strand_files.h"

namespace pelage {

namespace {

void print_vector(Buffered& out, glm::vec3 v) { out.print("({}, {}, {})", v.x, v.y, v.z); }

/// A set of strands in the file.
struct FileSet {
  const StrandSet& strands;
  const StrandGroup& group;
  std::size_t before;  // strands in earlier sets
};

/// Collects the parts of a file in their order.
class Parts {
 public:
  explicit Parts(std::shared_ptr<const ExportedStrands> strands) : strands_(std::move(strands)) {}

  void add_text(std::string text) {
    parts_.push_back([text = std::move(text)](const Sink& sink) { return sink(text); });
  }

  /// Adds an array with `print(out, set, i)` for each point, or for each strand, of all sets.
  template <class Print>
  void add_array(std::string_view declaration, bool of_points, std::string_view interpolation, const Print& print) {
    add_text(fmt::format("        {} = [", declaration));
    std::size_t before = 0;
    for (std::size_t k = 0; k < strands_->sets.size(); ++k) {
      const FileSet set{strands_->sets[k], strands_->groups[strands_->group_of[k]], before};
      const std::size_t count = of_points ? set.strands.points.size() : set.strands.count();
      parts_.push_back([kept = strands_, set, count, print](const Sink& sink) {
        Buffered out(sink);
        for (std::size_t i = 0; i < count && out.going(); ++i) {
          if (set.before + i > 0) out.print(", ");
          print(out, set, i);
        }
        return out.finish();
      });
      before += set.strands.count();
    }
    if (interpolation.empty()) return add_text("]\n");
    add_text(fmt::format("] (\n            interpolation = \"{}\"\n        )\n", interpolation));
  }

  /// Adds the text that `print(out)` writes.
  template <class Print>
  void add(const Print& print) {
    parts_.push_back([print](const Sink& sink) {
      Buffered out(sink);
      print(out);
      return out.finish();
    });
  }

  std::vector<FilePart> take() { return std::move(parts_); }

 private:
  const std::shared_ptr<const ExportedStrands> strands_;
  std::vector<FilePart> parts_;
};

/// Returns whether the up axis is Z; USD has only Y and Z.
bool is_z(Axis up) { return up == Axis::plus_z || up == Axis::minus_z; }

/// Prints a declaration with an array of values in brackets.
template <class Values, class Print>
void print_list(Buffered& out, std::string_view declaration, const Values& values, const Print& print) {
  out.print("        {} = [", declaration);
  for (std::size_t i = 0; i < values.size() && out.going(); ++i) {
    if (i > 0) out.print(", ");
    print(values[i]);
  }
  out.print("]");
}

void print_skin(Buffered& out, const ExportedSkin& skin) {
  const auto vector = [&out](glm::vec3 v) { print_vector(out, v); };
  out.print("\n    def Mesh \"skin\"\n    {{\n        uniform token subdivisionScheme = \"none\"\n");
  print_list(out, "int[] faceVertexCounts", skin.triangles, [&out](const glm::uvec3&) { out.print("3"); });
  out.print("\n");
  print_list(out, "int[] faceVertexIndices", skin.triangles,
             [&out](const glm::uvec3& t) { out.print("{}, {}, {}", t.x, t.y, t.z); });
  out.print("\n");
  print_list(out, "point3f[] points", skin.points, vector);
  out.print("\n");
  print_list(out, "normal3f[] normals", skin.normals, vector);
  out.print(" (\n            interpolation = \"vertex\"\n        )\n");
  if (!skin.uvs.empty()) {
    print_list(out, "texCoord2f[] primvars:st", skin.uvs, [&out](const std::array<glm::vec2, 3>& uv) {
      out.print("({}, {}), ({}, {}), ({}, {})", uv[0].x, uv[0].y, uv[1].x, uv[1].y, uv[2].x, uv[2].y);
    });
    out.print(" (\n            interpolation = \"faceVarying\"\n        )\n");
  }
  out.print("    }}\n");
}

/// Returns the tokens of a curve through the points. A cubic curve only reaches both end points if it is pinned.
const char* tokens_of(CurveBasis basis) {
  return basis == CurveBasis::linear ? "\"linear\"\n        uniform token wrap = \"nonperiodic\""
                                     : "\"cubic\"\n        uniform token basis = \"catmullRom\"\n"
                                       "        uniform token wrap = \"pinned\"";
}

std::string header(const ExportedStrands& strands, const UsdaForm& form) {
  const glm::dvec3 centre = strands.transform.centre;
  return fmt::format(R"(#usda 1.0
(
    customLayerData = {{
        string generator = "Pelage"
        int revision = {}
    }}
    defaultPrim = "groom"
    metersPerUnit = {}
    upAxis = "{}"
)

def Xform "groom" (
    prepend apiSchemas = ["GroomAPI"]
)
{{
    double3 xformOp:translate = ({}, {}, {})
    uniform token[] xformOpOrder = ["xformOp:translate"]

    def BasisCurves "fur"
    {{
        uniform token type = {}
)",
                     form.revision, strands.transform.metres, is_z(strands.transform.up) ? "Z" : "Y", centre.x,
                     centre.y, centre.z, tokens_of(form.basis));
}

std::string extent(const ExportedStrands& strands) {
  glm::vec3 low(0), high(0);
  bool any = false;
  for (const StrandSet& set : strands.sets) {
    for (const StrandPoint& point : set.points) {
      const glm::vec3 position = strands.file_offset(point), half(strands.model_width(point) / 2);
      low = any ? glm::min(low, position - half) : position - half;
      high = any ? glm::max(high, position + half) : position + half;
      any = true;
    }
  }
  return fmt::format("        float3[] extent = [({}, {}, {}), ({}, {}, {})]\n", low.x, low.y, low.z, high.x, high.y,
                     high.z);
}

void add_points(const ExportedStrands& strands, Parts& parts) {
  parts.add_array("int[] curveVertexCounts", false, "",
                  [](Buffered& out, const FileSet& set, std::size_t) { out.print("{}", set.strands.segments + 1); });
  parts.add_array("point3f[] points", true, "", [&strands](Buffered& out, const FileSet& set, std::size_t i) {
    print_vector(out, strands.file_offset(set.strands.points[i]));
  });
  for (const char* name : {"float[] widths", "float[] primvars:groom_width"}) {
    parts.add_array(name, true, "vertex", [&strands](Buffered& out, const FileSet& set, std::size_t i) {
      out.print("{}", strands.model_width(set.strands.points[i]));
    });
  }
  for (const char* name : {"color3f[] primvars:displayColor", "float3[] primvars:groom_color"}) {
    parts.add_array(name, true, "vertex", [](Buffered& out, const FileSet& set, std::size_t i) {
      print_vector(out, unpack_colour(set.strands.colours[i]));
    });
  }
}

void add_root_uvs(const ExportedStrands& strands, Parts& parts) {
  if (strands.root_uvs.empty()) return;
  for (const char* name : {"texCoord2f[] primvars:st", "float2[] primvars:groom_root_uv"}) {
    parts.add_array(name, false, "uniform", [&strands](Buffered& out, const FileSet& set, std::size_t i) {
      const glm::vec2 uv = strands.root_uvs[set.before + i];
      out.print("({}, {})", uv.x, uv.y);
    });
  }
}

/// Returns the text as a quoted USD string.
std::string quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return quoted + '"';
}

void add_groom_names(bool as_guides, Parts& parts) {
  parts.add_array("int[] primvars:groom_id", false, "uniform",
                  [](Buffered& out, const FileSet& set, std::size_t i) { out.print("{}", set.before + i); });
  parts.add_array("int[] primvars:groom_group_id", false, "uniform",
                  [](Buffered& out, const FileSet& set, std::size_t) { out.print("{}", set.group.id); });
  parts.add_array("string[] primvars:groom_group_name", false, "uniform",
                  [](Buffered& out, const FileSet& set, std::size_t) { out.print("{}", quoted(set.group.name)); });
  parts.add_text(
      fmt::format("        int[] primvars:groom_guide = [{}] (\n            interpolation = \"constant\"\n        )\n",
                  as_guides ? 1 : 0));
}

}  // namespace

std::vector<FilePart> usda_parts(const std::shared_ptr<const ExportedStrands>& strands, const UsdaForm& form) {
  Parts parts(strands);
  parts.add_text(header(*strands, form) + extent(*strands));
  add_points(*strands, parts);
  add_root_uvs(*strands, parts);
  add_groom_names(form.as_guides, parts);
  parts.add_text("    }\n");
  if (strands->skin) parts.add([strands](Buffered& out) { print_skin(out, *strands->skin); });
  parts.add_text("}\n");
  return parts.take();
}

}  // namespace pelage
