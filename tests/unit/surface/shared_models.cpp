#include "tests/unit/surface/shared_models.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace pelage::shared_models {

namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::stringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const std::size_t first = cell.find_first_not_of(' '), last = cell.find_last_not_of(' ');
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

}  // namespace

std::string folder() {
  const char* named = std::getenv("PELAGE_SHARED");
  const std::string path = (named ? named : std::string(PELAGE_SOURCE_DIR) + "/../shared") + "/meshes";
  return std::filesystem::exists(path + "/README.md") ? path : "";
}

std::string read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

std::vector<Row> table(const std::string& title) {
  std::stringstream text(read_file(folder() + "/README.md"));
  std::vector<Row> rows;
  std::vector<std::string> names;
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("## ")) inside = line == "## " + title;
    if (!inside || !line.starts_with("|") || line.starts_with("|---")) continue;
    const std::vector<std::string> cells = cells_of(line);
    if (names.empty()) {
      names = cells;
      continue;
    }
    Row row;
    for (std::size_t i = 0; i < cells.size() && i < names.size(); ++i) row[names[i]] = cells[i];
    rows.push_back(row);
  }
  return rows;
}

std::vector<std::pair<std::string, std::string>> equal_pairs() {
  static const std::regex chain(R"(([\w.]+)((?: = [\w.]+)+))");
  static const std::regex link(R"( = ([\w.]*\w))");
  const std::string text = read_file(folder() + "/README.md");
  std::vector<std::pair<std::string, std::string>> pairs;
  for (std::sregex_iterator c(text.begin(), text.end(), chain), end; c != end; ++c) {
    const std::string others = (*c)[2];
    for (std::sregex_iterator l(others.begin(), others.end(), link); l != end; ++l)
      pairs.emplace_back((*c)[1], (*l)[1]);
  }
  return pairs;
}

std::optional<ModelFormat> format_of(const std::string& file) {
  static const std::map<std::string, ModelFormat> formats = {
      {".obj", ModelFormat::obj}, {".ply", ModelFormat::ply},   {".stl", ModelFormat::stl}, {".off", ModelFormat::off},
      {".glb", ModelFormat::glb}, {".gltf", ModelFormat::gltf}, {".3ds", ModelFormat::tds}};
  const auto entry = formats.find(std::filesystem::path(file).extension().string());
  return entry == formats.end() ? std::nullopt : std::optional(entry->second);
}

Result<RawModel> import_file(const std::string& path) {
  const std::string bytes = read_file(path);
  return import_model(PELAGE_IMPORT, format_of(path).value(), std::as_bytes(std::span(bytes)));
}

Result<Mesh> load_file(const std::string& path) {
  const Result<RawModel> raw = import_file(path);
  if (!raw.ok()) return raw.status();
  return prepare(*raw, {.source_is_32_bit = raw->is_32_bit});
}

}  // namespace pelage::shared_models
