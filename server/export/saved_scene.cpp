#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <type_traits>

#include "server/export/export_file.h"
#include "server/export/temporary_folder.h"

namespace pelage {

namespace {

bool copy_file(const std::string& path, const Sink& sink) {
  std::ifstream file(path, std::ios::binary);
  std::string chunk(std::size_t{1} << 18, '\0');
  while (file.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || file.gcount() > 0) {
    if (!sink(std::string_view(chunk).substr(0, static_cast<std::size_t>(file.gcount())))) return false;
  }
  return true;
}

Status check_size(const std::string& path, std::uint64_t max, const char* what) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (error) return failure(Code::internal, "a temporary file cannot be read: " + error.message());
  if (bytes <= max) return {};
  return failure(Code::too_large, "The scene is too large for a file that opens again: its log takes the most.", "",
                 "at most " + std::to_string(max) + " bytes " + what);
}

constexpr std::size_t chunk_bytes = std::size_t{1} << 18;

struct Close {
  void operator()(gzFile file) const { gzclose(file); }
};
using GzipFile = std::unique_ptr<std::remove_pointer_t<gzFile>, Close>;

Status cannot_be_written() {
  return failure(Code::internal, "a temporary file cannot be written; see that TMPDIR has room");
}

/// Compresses a file by gzip, whose checksum detects damage. Fails (internal) if a file cannot be read or written.
/// `between` is called before each chunk and may throw to stop the work.
Status compress_file(const std::string& from, const std::string& to, const std::function<void()>& between) {
  std::ifstream input(from, std::ios::binary);
  GzipFile output(gzopen(to.c_str(), "wb"));
  std::string chunk(chunk_bytes, '\0');
  if (!input || !output) return cannot_be_written();
  while (input.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || input.gcount() > 0) {
    if (between) between();
    const auto size = static_cast<unsigned>(input.gcount());
    if (gzwrite(output.get(), chunk.data(), size) != static_cast<int>(size)) return cannot_be_written();
  }
  return gzclose(output.release()) == Z_OK ? Status{} : cannot_be_written();
}

}  // namespace

Result<ExportFile> export_saved(const SceneStore& store, const Scene& scene, const Cancel& cancel,
                                const SavedLimits& max) try {
  Result<TemporaryFolder> made = TemporaryFolder::make();
  if (!made) return made.status();
  const auto folder = std::make_shared<const TemporaryFolder>(std::move(*made));
  ExportFile file;
  const std::string plain = folder->file("scene"), path = folder->file("scene.pelage");
  const Result<Revision> saved = store.save(scene, plain, cancel);
  if (!saved) return saved.status();
  file.about.format = ExportFormat::pelage, file.about.revision = *saved;
  if (Status large = check_size(plain, max.unpacked, "unpacked"); !large.ok()) return large;
  if (Status compressed = compress_file(plain, path, [&] { cancel.check(); }); !compressed.ok()) return compressed;
  if (Status large = check_size(path, max.bytes, "packed"); !large.ok()) return large;
  file.content_type = "application/gzip", file.ending = ".pelage";
  file.parts = {[folder, path](const Sink& sink) { return copy_file(path, sink); }};
  file.about.bytes = size_of(file.parts, cancel);
  return file;
} catch (const Cancelled&) {
  return nobody_waits();
}

Result<std::shared_ptr<Scene>> open_saved(SceneStore& store, const std::string& bytes, const std::string& name,
                                          const Cancel& cancel) {
  const Result<TemporaryFolder> folder = TemporaryFolder::make();
  if (!folder) return folder.status();
  return store.open_saved(std::as_bytes(std::span(bytes)), folder->file("rows"), name, cancel);
}

}  // namespace pelage
