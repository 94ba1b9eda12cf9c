#include "clients/cli/pack/pack.h"

#include <zip.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <sstream>
#include <string_view>

#include "base/percent.h"
#include "protocol/json/parse.h"

namespace pelage {

namespace {

namespace fs = std::filesystem;

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

/// Calls visit(word, rest) for each line that is not blank: its first word, and the trimmed text after it.
template <class Visit>
void for_each_line(const std::string& text, const Visit& visit) {
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    constexpr const char* blanks = " \t\r";
    const std::size_t begin = line.find_first_not_of(blanks);
    if (begin == std::string::npos) continue;
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    const std::size_t rest = line.find_first_not_of(blanks, end);
    const std::size_t last = line.find_last_not_of(blanks);
    visit(line.substr(begin, end - begin), rest == std::string::npos ? "" : line.substr(rest, last + 1 - rest));
  }
}

std::optional<std::string> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  return file ? std::optional(std::move(bytes)) : std::nullopt;
}

/// Returns a name as a normalized path relative to the model's folder; nothing if it leads out of that folder.
std::optional<fs::path> path_in_folder(std::string name) {
  std::replace(name.begin(), name.end(), '\\', '/');
  const fs::path path = fs::path(name).lexically_normal();
  if (path.is_absolute() || path.empty() || *path.begin() == "..") return {};
  return path;
}

/// Collects the files that a model references and zips them with it.
class Packer {
 public:
  Packer(const fs::path& model, std::size_t max_bytes) : folder_(model.parent_path()), max_bytes_(max_bytes) {}

  /// Reads a file and returns its bytes. If it cannot be read, adds the name to missing() and returns null.
  const std::string* add(const std::string& name) {
    for (const std::string& spelling : {name, percent_decoded(name)}) {
      const std::optional<fs::path> path = path_in_folder(spelling);
      std::optional<std::string> bytes = path ? bytes_of(folder_ / *path) : std::nullopt;
      if (bytes) return &files_.emplace_back(path->generic_string(), std::move(*bytes)).second;
    }
    missing_.push_back(name);
    return nullptr;
  }

  bool is_too_large() const {
    std::size_t bytes = 0;
    for (const auto& file : files_) bytes += file.second.size();
    return bytes > max_bytes_;
  }
  bool has_files() const { return !files_.empty(); }
  std::vector<std::string>& missing() { return missing_; }

  Result<std::string> zip(const std::string& name, const std::string& model) const;

 private:
  fs::path folder_;
  std::size_t max_bytes_;
  std::vector<std::pair<std::string, std::string>> files_;  // relative path, bytes
  std::vector<std::string> missing_;
};

/// Adds a file to the archive without compression: pictures would not get smaller, and the transfer is short.
bool add_to(zip_t* archive, const std::string& name, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  const zip_int64_t index = source ? zip_file_add(archive, name.c_str(), source, ZIP_FL_OVERWRITE) : -1;
  if (index < 0) zip_source_free(source);
  return index >= 0 && zip_set_file_compression(archive, static_cast<zip_uint64_t>(index), ZIP_CM_STORE, 0) == 0;
}

Result<std::string> Packer::zip(const std::string& name, const std::string& model) const {
  const Status failed = failure(Code::internal, "The model cannot be packed with its files.");
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  if (!target) return failed;
  zip_source_keep(target);
  const std::unique_ptr<zip_source_t, decltype(&zip_source_free)> source_owner(target, zip_source_free);
  zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  if (!archive) return failed;
  bool good = add_to(archive, name, model);
  for (const auto& [path, bytes] : files_) good = good && add_to(archive, path, bytes);
  if (!good || zip_close(archive) != 0) return zip_discard(archive), failed;
  zip_stat_t stat;
  if (zip_source_open(target) != 0 || zip_source_stat(target, &stat) != 0) return failed;
  std::string bytes(stat.size, '\0');
  if (zip_source_read(target, bytes.data(), bytes.size()) != static_cast<zip_int64_t>(bytes.size())) return failed;
  return bytes;
}

void add_referenced(const std::string& extension, const std::string& model, Packer& packer) {
  if (extension == "gltf") {
    for (const std::string& name : names_in_gltf(model)) packer.add(name);
    return;
  }
  for (const std::string& library : names_in_obj(model)) {
    const std::string* text = packer.add(library);
    const std::vector<std::string> pictures = text ? names_in_mtl(*text) : std::vector<std::string>();
    for (const std::string& picture : pictures) packer.add(picture);
  }
}

}  // namespace

std::vector<std::string> names_in_obj(const std::string& text) {
  std::vector<std::string> names;
  for_each_line(text, [&](const std::string& word, const std::string& rest) {
    if (word == "mtllib") add_once(names, rest);
  });
  return names;
}

std::vector<std::string> names_in_mtl(const std::string& text) {
  std::vector<std::string> names;
  for_each_line(text, [&](const std::string& word, const std::string& rest) {
    if (word != "map_Kd") return;
    const bool has_options = rest.starts_with("-");  // then the file name comes last
    add_once(names, has_options ? rest.substr(rest.find_last_of(" \t") + 1) : rest);
  });
  return names;
}

std::vector<std::string> names_in_gltf(const std::string& text) {
  std::vector<std::string> names;
  const auto root = parse_json(text);
  if (!root || !root->is_object()) return names;
  for (const char* kind : {"buffers", "images"}) {
    const auto list = root->find(kind);
    if (list == root->end() || !list->is_array()) continue;
    for (const auto& entry : *list) {
      const std::string uri = entry.is_object() && entry.contains("uri") && entry["uri"].is_string()
                                  ? entry["uri"].get<std::string>()
                                  : std::string();
      if (!uri.starts_with("data:")) add_once(names, uri);
    }
  }
  return names;
}

Result<PackedModel> pack_model(const std::string& path, const std::string& extension, std::size_t max_bytes) {
  std::optional<std::string> model = bytes_of(path);
  if (!model) return failure(Code::not_found, "Cannot read " + path + ".");
  PackedModel packed;
  Packer packer(path, max_bytes);
  if (extension == "obj" || extension == "gltf") add_referenced(extension, *model, packer);
  packed.missing = std::move(packer.missing());
  if (packer.is_too_large() || model->size() > max_bytes)
    return failure(Code::too_large, path + " with the files that it names is too large.", "",
                   "at most " + std::to_string(max_bytes) + " bytes");
  if (!packer.has_files()) return packed.bytes = std::move(*model), packed;
  const auto zip = packer.zip(fs::path(path).filename().generic_string(), *model);
  if (!zip) return zip.status();
  packed.bytes = *zip, packed.is_zip = true;
  return packed;
}

}  // namespace pelage
