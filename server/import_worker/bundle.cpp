#include "server/import_worker/bundle.h"

#include <zip.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "base/limits.h"
#include "base/percent.h"
#include "protocol/json/names.h"
#include "server/import_worker/parse.h"

namespace pelage {

namespace {

struct Closer {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
  return result;
}

std::string last_name(std::string_view path) { return std::string(path.substr(path.rfind('/') + 1)); }

std::optional<ModelFormat> format_of(std::string_view path) {
  const std::string name = lower(last_name(path));
  if (name.starts_with(".")) return {};  // metadata that macOS stores beside files
  const std::string ending = name.substr(std::min(name.rfind('.'), name.size() - 1) + 1);
  for (const auto& known : json_names::model_formats)
    if (known.text == ending && known.value != ModelFormat::zip) return known.value;
  return {};
}

/// Returns the path with slashes, without "." and "..".
std::string normal(std::string path) {
  std::replace(path.begin(), path.end(), '\\', '/');
  return std::filesystem::path(path).lexically_normal().generic_string();
}

Result<std::string> read_entry(zip_t* archive, zip_uint64_t index, const zip_stat_t& stat, std::size_t room) {
  if (stat.encryption_method != ZIP_EM_NONE) return broken("the archive needs a password; pack it without one.");
  if (stat.size > room)
    return broken("the archive becomes larger than " + std::to_string(4 * limits::model_bytes) + " bytes.");
  const std::unique_ptr<zip_file_t, Closer> file(zip_fopen_index(archive, index, 0));
  std::string bytes(stat.size, '\0');
  if (!file || zip_fread(file.get(), bytes.data(), bytes.size()) != static_cast<zip_int64_t>(bytes.size()))
    return broken(std::string("\"") + stat.name + "\" in the archive is broken; pack it again.");
  return bytes;
}

Result<std::vector<BundledFile>> unpacked(const std::string& zip) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(zip.data(), zip.size(), 0, &error);
  const std::unique_ptr<zip_t, Closer> archive(source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr);
  if (!archive) {
    zip_source_free(source);
    return broken("it is no zip archive that can be read; pack it again.");
  }
  std::size_t room = 4 * limits::model_bytes;
  std::vector<BundledFile> files;
  for (zip_int64_t i = 0; i < zip_get_num_entries(archive.get(), 0); ++i) {
    zip_stat_t stat;
    const auto index = static_cast<zip_uint64_t>(i);
    if (zip_stat_index(archive.get(), index, 0, &stat) != 0) return broken("the archive's list of files is broken.");
    if (std::string_view(stat.name).ends_with('/')) continue;
    Result<std::string> bytes = read_entry(archive.get(), index, stat, room);
    if (!bytes) return bytes.status();
    room -= bytes->size();
    files.push_back({normal(stat.name), std::move(*bytes)});
  }
  return files;
}

}  // namespace

Result<Bundle> Bundle::unpack(const std::string& zip, ModelFormat& format) {
  Result<std::vector<BundledFile>> files = unpacked(zip);
  if (!files) return files.status();
  Bundle bundle;
  bundle.files_ = std::move(*files);
  const auto is_model = [](const BundledFile& file) { return format_of(file.path).has_value(); };
  const auto first = std::find_if(bundle.files_.begin(), bundle.files_.end(), is_model);
  if (first == bundle.files_.end())
    return broken("the archive has no model in a format that is read; see docs/models.md.");
  const auto second = std::find_if(first + 1, bundle.files_.end(), is_model);
  if (second != bundle.files_.end())
    return broken("the archive has several models, \"" + first->path + "\" and \"" + second->path +
                  "\"; pack one with the files that it names.");
  format = *format_of(first->path);
  std::rotate(bundle.files_.begin(), first, first + 1);
  return bundle;
}

const std::string* Bundle::find(std::string_view name) const {
  const std::string folder = path().substr(0, path().rfind('/') + 1);
  for (const std::string& wanted : {normal(folder + std::string(name)), normal(folder + percent_decoded(name))}) {
    for (const BundledFile& file : files_)
      if (file.path == wanted) return &file.bytes;
  }
  const std::string wanted = lower(last_name(normal(percent_decoded(name))));
  const std::string* found = nullptr;
  for (const BundledFile& file : files_) {
    if (lower(last_name(file.path)) != wanted) continue;
    if (found) return nullptr;
    found = &file.bytes;
  }
  return found;
}

}  // namespace pelage
