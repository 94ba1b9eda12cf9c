// All scenes of the server. They are restored from the journal after a restart.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/guides.h"
#include "protocol/commands/scene.h"
#include "server/history/journal.h"
#include "server/scene/moving_model.h"
#include "server/scene/open_scenes.h"
#include "server/scene/scene.h"

namespace pelage {

/// Thread-safe.
class SceneStore {
 public:
  /// Opens or creates `data_folder`/pelage.sqlite and restores every scene in it, with its log and revision, from the
  /// stored deltas. The intact part of a damaged scene is restored (Scene::quarantine). `worker` is the path of
  /// pelage-import; at most `undo_bytes` of each scene's undo steps stay in memory. While open scenes take more than
  /// `memory` bytes, the least recently used ones that are not in use are evicted; `find` opens them again. Fails
  /// (internal) with the reason if the journal cannot be used.
  static Result<std::unique_ptr<SceneStore>> open(const std::string& data_folder, const std::string& worker,
                                                  std::size_t undo_bytes = limits::undo_bytes,
                                                  std::size_t memory = std::numeric_limits<std::size_t>::max());
  ~SceneStore();

  /// Returns the object that makes poses of the scene's model for Scene::pose.
  Result<MovingModel> moving_model(const Scene& scene) const;
  /// Returns an id for a new model, unique in the process.
  std::uint64_t new_model_id() const;

  /// Makes a scene of a built-in model. Refuses (conflict) at the limit of scenes.
  Result<std::shared_ptr<Scene>> create(const NewScene& request, const std::optional<KeyedRequest>& keyed = {});
  /// Makes an independent scene that begins with the state of `from`, at a revision if the request names one. Refuses
  /// (conflict) at the limit of scenes; fails as Scene::branch does.
  Result<std::shared_ptr<Scene>> branch(const Scene& from, const BranchRequest& request,
                                        const std::optional<KeyedRequest>& keyed = {});
  /// Returns a scene. An evicted one is restored from the journal, as `open` restores it.
  Result<std::shared_ptr<Scene>> find(const std::string& id) const;
  Status remove(const std::string& id);
  /// Returns the change that a request with this path and key made, even before a restart. The caller compares the
  /// fingerprint, which may differ.
  Result<std::optional<RequestedChange>> change_of_request(const KeyedRequest& request) const;
  /// As Journal::health.
  Status health() const;
  /// Returns a line for each scene that is damaged now, and for each that had lost entries when the store was opened.
  std::vector<std::string> damages() const;
  /// Returns summaries as of each scene's last change; does not wait for running changes.
  std::vector<SceneSummary> list() const;
  std::size_t count() const;
  MemoryUse memory() const;
  /// Calls `forget` with the SceneView::copy_id of each scene that is evicted or removed. Must be called before other
  /// threads use the store.
  void on_close(OpenScenes::OnClose forget);
  /// Counts the renderer's copies of scenes against the budget. Must be called before other threads use the store.
  void count_copies(OpenScenes::CopyBytes copy_bytes);
  /// Counts baked coats against the budget, likewise.
  void count_coats(std::function<std::size_t()> coat_bytes);

  /// Imports a model with the worker and sets it as the scene's model. At most two imports run at a time; more are
  /// refused (busy).
  Result<SceneSummary> load_model(Scene& scene, const ImportOptions& options, std::span<const std::byte> bytes,
                                  const ExecuteOptions& execute = {});

  /// Imports a new version of the scene's model, with the same up and front axes, and transfers the groom to it
  /// (Scene::transfer_groom_to). The scene's state before that is kept as another scene, which the summary names.
  /// Refuses (conflict) at the limit of scenes.
  Result<SceneSummary> load_version(Scene& scene, const ImportOptions& options, std::span<const std::byte> bytes,
                                    ExecuteOptions execute = {});

  /// Subdivides the scene's model as Scene::subdivide does.
  Result<SceneSummary> subdivide(Scene& scene, const Subdivide& how, const ExecuteOptions& execute = {});
  /// Rotates the scene's model as Scene::turn does.
  Result<SceneSummary> turn(Scene& scene, const TurnModel& how, const ExecuteOptions& execute = {});

  /// Returns the grooms that the retargets among the commands take, copied before their target is locked. Refuses
  /// (invalid) "/scene" if there is no such scene, "/revision" if its model has no such revision; in a batch the
  /// pointer begins with "/commands/K".
  Result<std::vector<GroomSource>> sources_of(const std::vector<Command>& commands) const;
  /// Calls Scene::execute with the result of sources_of.
  Result<CommandAnswer> execute(Scene& scene, const std::vector<Command>& commands, ExecuteOptions options = {}) const;
  /// Calls Scene::amend with those sources and with the sources of the retargets in the scene's log.
  Result<CommandAnswer> amend(Scene& scene, const AmendRequest& request, ExecuteOptions options = {}) const;

  /// Imports an environment map with the worker and lights the scene with it. It runs a set_environment that holds
  /// `how` and the map's spherical harmonics, so that running the command again needs no picture. Counts as an import.
  Result<CommandAnswer> load_environment(Scene& scene, EnvironmentUpload how, std::span<const std::byte> bytes,
                                         const ExecuteOptions& execute = {});

  /// Imports a PNG or JPEG with the worker and sets it as the skin texture. Counts as an import.
  Result<CommandAnswer> load_skin_texture(Scene& scene, std::span<const std::byte> bytes,
                                          const ExecuteOptions& execute = {});
  /// Imports guide curves with the worker and grooms the fur along them (follow_guides).
  Result<CommandAnswer> load_guides(Scene& scene, const GuideUpload& upload, std::span<const std::byte> bytes,
                                    const ExecuteOptions& execute = {});
  /// Stores the picture and names it in a set_skin_texture. Fails as that command does.
  Result<CommandAnswer> store_skin_texture(Scene& scene, const RawImage& picture, const ExecuteOptions& execute = {});
  /// Stores a data picture that commands can name. A picture that no log names is dropped at a restart.
  Result<PictureAnswer> store_picture(std::span<const std::byte> bytes, const Cancel& cancel = {});
  /// Stores a data picture as store_picture does and applies it as a map (ApplyMap). Fails as that command does.
  Result<CommandAnswer> load_map(Scene& scene, const MapUpload& upload, std::span<const std::byte> bytes,
                                 const ExecuteOptions& execute = {});

  /// Writes the scene with its model, log and pictures to a file of its own: a journal of one scene. The scene can be
  /// changed and read meanwhile. Returns the revision that the file has; unavailable if cancelled.
  Result<Revision> save(const Scene& scene, const std::string& path, const Cancel& cancel = {}) const;
  /// Makes a scene from a gzip-compressed file of that kind, which is untrusted; an empty `name` keeps the file's. The
  /// worker reads the file, its rows are checked in a journal at `scratch`, a path that must not exist yet, and then
  /// they enter the store in one transaction. Refuses (invalid) a file that is no such file, is damaged, or holds a
  /// scene that commands could not have made; unavailable if cancelled.
  Result<std::shared_ptr<Scene>> open_saved(std::span<const std::byte> bytes, const std::string& scratch,
                                            const std::string& name, const Cancel& cancel = {});

 private:
  struct Impl;
  explicit SceneStore(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
