#include "server/import_worker/signature.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "server/import/import.h"
#include "server/import_worker/parse.h"

namespace pelage {

namespace {

using namespace std::string_view_literals;

struct Signature {
  std::string_view begin;
  const char* what;
  const char* next;
};

/// Signatures of files that are not read as models.
constexpr std::array others{
    Signature{"\x1f\x8b"sv, "gzip", "unpack it, and load what was in it"},
    Signature{"7z\xbc\xaf\x27\x1c"sv, "a 7z archive", "unpack it, and load what was in it"},
    Signature{"\x89PNG"sv, "a PNG picture", "`pelage skin-texture` lays one on a model"},
    Signature{"\xff\xd8\xff"sv, "a JPEG picture", "`pelage skin-texture` lays one on a model"},
    Signature{"Kaydara FBX Binary"sv, "an FBX file", "save it as GLB, as Blender does"},
    Signature{"; FBX"sv, "an FBX file", "save it as GLB, as Blender does"},
    Signature{"BLENDER"sv, "a Blender file", "export it from Blender as GLB"},
    Signature{"PXR-USDC"sv, "a USD file", "save it as GLB, as Blender does"},
    Signature{"#usda"sv, "a USD file", "save it as GLB, as Blender does"},
    Signature{"<!DOCTYPE"sv, "a web page", "fetch the file itself and not the page about it"},
    Signature{"<html"sv, "a web page", "fetch the file itself and not the page about it"},
    Signature{"<?xml"sv, "XML, such as COLLADA", "save it as GLB, as Blender does"},
    Signature{"version https://git-lfs"sv, "a pointer of Git LFS", "fetch the file itself with `git lfs pull`"},
    Signature{"\xfe\xff"sv, "text in UTF-16", "save it as UTF-8"},
    Signature{"\xff\xfe"sv, "text in UTF-16", "save it as UTF-8"},
};

bool is_text_stl(std::string_view bytes) {
  constexpr std::size_t far_enough = 2000;
  return bytes.starts_with("solid") && bytes.substr(0, far_enough).find("facet") != std::string_view::npos;
}

/// Recognizes OBJ as text with a vertex on a line of its own; no binary format begins with that.
bool is_obj(std::string_view bytes) {
  const std::string_view begin = without_byte_order_mark(bytes).substr(0, 2000);
  const auto is_text = [](char c) {
    return c == '\t' || c == '\n' || c == '\r' || static_cast<unsigned char>(c) >= ' ';
  };
  const bool has_vertex = begin.starts_with("v ") || begin.find("\nv ") != std::string_view::npos;
  return has_vertex && std::all_of(begin.begin(), begin.end(), is_text);
}

/// Recognizes a glTF document by its member "asset", which is required.
bool is_gltf(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && bytes[first] == '{' && bytes.find("\"asset\"") != std::string_view::npos;
}

std::optional<ModelFormat> known_format(std::string_view bytes) {
  if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return ModelFormat::ply;
  if (bytes.starts_with("glTF")) return ModelFormat::glb;
  if (bytes.starts_with("PK\x03\x04")) return ModelFormat::zip;
  if (bytes.starts_with("OFF\n") || bytes.starts_with("OFF\r") || bytes.starts_with("COFF")) return ModelFormat::off;
  if (is_text_stl(bytes)) return ModelFormat::stl;
  if (is_gltf(bytes)) return ModelFormat::gltf;
  if (is_obj(bytes)) return ModelFormat::obj;
  return {};
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

Status check_signature(ModelFormat format, std::string_view bytes) {
  const auto other =
      std::find_if(others.begin(), others.end(), [&](const Signature& each) { return bytes.starts_with(each.begin); });
  if (other != others.end()) return broken(std::string("its bytes are ") + other->what + "; " + other->next + ".");
  const std::optional<ModelFormat> found = known_format(bytes);
  if (!found || *found == format) return {};
  const std::string name = worker_format_names[static_cast<std::size_t>(*found)];
  return broken("its bytes are of the format " + name + "; load it with --format " + name + ".");
}

}  // namespace pelage
