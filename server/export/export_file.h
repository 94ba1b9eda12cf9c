// A scene's fur as a file of another program: what it holds is known before its bytes are made, piece by piece.
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

/// Takes the next bytes of a file; false ends the writing.
using Sink = std::function<bool(std::string_view)>;

/// Makes the same bytes each time; false when the sink ended it.
using FilePart = std::function<bool(const Sink&)>;

struct ExportFile {
  ExportAnswer about;
  const char* content_type = "";
  std::string ending;           // ".usda"
  std::vector<FilePart> parts;  // one after the other they are the file; each can be made on a thread of its own

  bool write(const Sink& sink) const;
};

/// Exports the scene itself, or a file that is made of a snapshot of it. Fails as both do.
Result<ExportFile> export_file(const SceneStore& store, const Scene& scene, const ExportRequest& request,
                               const Cancel& cancel = {});

/// Grows all strands of the scene, which stay in memory as long as the file: about 160 bytes each, curls more. Refused
/// (too_large): "/every" where more than limits::export_strands are expected, and a GLB that cannot be so large;
/// unavailable once nobody waits, which is asked on several threads.
Result<ExportFile> export_scene(const SceneSnapshot& scene, const ExportRequest& request, const Cancel& cancel = {});

/// The limits of what open_saved takes.
struct SavedLimits {
  std::uint64_t bytes = limits::model_bytes;     // of the file
  std::uint64_t unpacked = limits::saved_bytes;  // after decompression
};

/// The scene itself: what SceneStore::save writes, as gzip. The file lies in a temporary folder as long as this does.
/// Refused (too_large) where no server would open it; unavailable once nobody waits.
Result<ExportFile> export_saved(const SceneStore& store, const Scene& scene, const Cancel& cancel = {},
                                const SavedLimits& max = {});

/// Makes a scene of the bytes of such a file, as SceneStore::open_saved.
Result<std::shared_ptr<Scene>> open_saved(SceneStore& store, const std::string& bytes, const std::string& name,
                                          const Cancel& cancel = {});

/// Returns the size of all parts, which are made on all cores to know it. Throws Cancelled.
std::uint64_t size_of(const std::vector<FilePart>& parts, const Cancel& cancel);

}  // namespace pelage
