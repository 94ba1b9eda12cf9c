// A scene's fur as a file of another program: what it holds is known before its bytes are made, piece by piece.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "protocol/base/status.h"
#include "protocol/commands/export.h"
#include "server/scene/scene.h"
#include "server/scene/scene_store.h"

namespace pelage {

/// Takes the next bytes of a file; false ends the writing.
using Sink = std::function<bool(std::string_view)>;

struct ExportFile {
  ExportAnswer about;
  const char* content_type = "";
  std::string ending;                      // ".usda"
  std::function<bool(const Sink&)> write;  // the same bytes each time; false when the sink ended it
};

/// Grows all strands of the scene, which stay in memory as long as the file: about 160 bytes each, curls more. Refused
/// (too_large, "/every") where more than limits::export_strands are expected; unavailable once nobody waits, which is
/// asked on several threads.
Result<ExportFile> export_scene(const SceneCopy& scene, const ExportRequest& request, const Cancel& cancel = {});

/// The scene itself: what SceneStore::save writes, as gzip. The file lies in a temporary folder as long as this does.
/// Unavailable once nobody waits.
Result<ExportFile> export_saved(const SceneStore& store, const Scene& scene, const Cancel& cancel = {});

/// Makes a scene of the bytes of such a file, as SceneStore::open_saved.
Result<std::shared_ptr<Scene>> open_saved(SceneStore& store, const std::string& bytes, const std::string& name);

/// The bytes that `write` makes.
std::uint64_t size_of(const std::function<bool(const Sink&)>& write);

}  // namespace pelage
