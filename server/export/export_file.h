// Exports a scene's fur as a file for another program. Its description is known before its bytes are made, in chunks.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/limits.h"
#include "base/status.h"
#include "protocol/commands/export.h"
#include "server/scene/scene.h"
#include "server/scene/scene_store.h"

namespace pelage {

/// Takes the next bytes of a file. Returns false to end the writing.
using Sink = std::function<bool(std::string_view)>;

/// Writes a part of a file, with the same bytes each time. Returns false if the sink has ended the writing.
using FilePart = std::function<bool(const Sink&)>;

struct ExportFile {
  ExportAnswer about;
  const char* content_type = "";
  std::string ending;           // ".usda"
  std::vector<FilePart> parts;  // the file is all parts in order; each can be written on a thread of its own

  bool write(const Sink& sink) const;
};

/// Exports the scene by export_saved or export_scene, depending on the format. Fails as they do.
Result<ExportFile> export_file(const SceneStore& store, const Scene& scene, const ExportRequest& request,
                               const Cancel& cancel = {});

/// Grows all strands of the scene in memory: about 160 bytes each, curls more. A file of strands keeps them. Refused:
/// too_large ("/every") if more than limits::export_strands are expected, or if a GLB would be too large; invalid
/// ("/coat") if the file needs the name of a coat or no coat has the name; unavailable once `cancel`, which is asked on
/// several threads, says so.
Result<ExportFile> export_scene(const SceneSnapshot& scene, const ExportRequest& request, const Cancel& cancel = {});

/// The limits of a file that open_saved accepts.
struct SavedLimits {
  std::uint64_t bytes = limits::model_bytes;     // size of the file
  std::uint64_t unpacked = limits::saved_bytes;  // size after decompression
};

/// Exports the scene itself: the output of SceneStore::save, compressed by gzip. It is kept in a temporary folder as
/// long as the returned file lives. Refused: too_large if no server would open it, unavailable once `cancel` says so.
Result<ExportFile> export_saved(const SceneStore& store, const Scene& scene, const Cancel& cancel = {},
                                const SavedLimits& max = {});

/// Makes a scene from the bytes of such a file by SceneStore::open_saved.
Result<std::shared_ptr<Scene>> open_saved(SceneStore& store, const std::string& bytes, const std::string& name,
                                          const Cancel& cancel = {});

/// Returns the total size of all parts in bytes. Writes them, on all cores, to count their bytes. Throws Cancelled.
std::uint64_t size_of(const std::vector<FilePart>& parts, const Cancel& cancel);

}  // namespace pelage
