#include <fstream>
#include <memory>

#include "protocol/base/limits.h"
#include "server/export/export_file.h"
#include "server/export/gzip.h"
#include "server/export/temporary_folder.h"

namespace pelage {

namespace {

bool copy_file(const std::string& path, const Sink& sink) {
  std::ifstream file(path, std::ios::binary);
  std::string piece(std::size_t{1} << 18, '\0');
  while (file.read(piece.data(), static_cast<std::streamsize>(piece.size())) || file.gcount() > 0) {
    if (!sink(std::string_view(piece).substr(0, static_cast<std::size_t>(file.gcount())))) return false;
  }
  return true;
}

}  // namespace

Result<ExportFile> export_saved(const SceneStore& store, const Scene& scene, const Cancel& cancel) try {
  Result<TemporaryFolder> made = TemporaryFolder::make();
  if (!made) return made.status();
  const auto folder = std::make_shared<const TemporaryFolder>(std::move(*made));
  ExportFile file;
  const std::string plain = folder->file("scene"), path = folder->file("scene.pelage");
  const Result<Revision> saved = store.save(scene, plain, cancel);
  if (!saved) return saved.status();
  file.about.format = ExportFormat::pelage, file.about.revision = *saved;
  if (Status compressed = compress_file(plain, path, [&] { cancel.check(); }); !compressed.ok()) return compressed;
  file.content_type = "application/gzip", file.ending = ".pelage";
  file.write = [folder, path](const Sink& sink) { return copy_file(path, sink); };
  file.about.bytes = size_of(file.write);
  return file;
} catch (const Cancelled&) {
  return nobody_waits();
}

Result<std::shared_ptr<Scene>> open_saved(SceneStore& store, const std::string& bytes, const std::string& name) {
  const Result<TemporaryFolder> folder = TemporaryFolder::make();
  if (!folder) return folder.status();
  const std::string path = folder->file("scene.pelage"), plain = folder->file("scene");
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) return failure(Code::internal, "the file cannot be kept for reading; see that TMPDIR has room");
  if (Status read = decompress_file(path, plain, limits::saved_bytes); !read.ok()) return SceneStore::not_saved(read);
  return store.open_saved(plain, name);
}

}  // namespace pelage
