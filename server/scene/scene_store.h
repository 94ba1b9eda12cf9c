// All scenes of the server, and how they survive a restart.
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
  /// Opens or makes `data_folder`/pelage.sqlite and restores every scene in it, with its log and revision, by the
  /// stored deltas. A scene that is damaged is restored as far as it is whole (Scene::quarantine). `worker` is the path
  /// of pelage-import; of each scene's undo steps at most `undo_bytes` stay in memory. While open scenes take more than
  /// `memory` bytes, the least recently used ones that nobody holds are evicted; `find` opens them again. Fails
  /// (internal) with the reason when the journal cannot be used.
  static Result<std::unique_ptr<SceneStore>> open(const std::string& data_folder, const std::string& worker,
                                                  std::size_t undo_bytes = limits::undo_bytes,
                                                  std::size_t memory = std::numeric_limits<std::size_t>::max());
  ~SceneStore();

  /// The scene's model, ready to stand elsewhere, as Scene::pose wants it.
  Result<MovingModel> moving_model(const Scene& scene) const;
  /// Returns an id for a new model, unique in the process.
  std::uint64_t new_model_id() const;

  /// Refused (busy) at the limit of scenes.
  Result<std::shared_ptr<Scene>> create(const NewScene& request, const std::optional<KeyedRequest>& keyed = {});
  /// A scene of its own that begins as `from` is or was at a revision. Refused: busy at the limit of scenes; as
  /// Scene::branch does.
  Result<std::shared_ptr<Scene>> branch(const Scene& from, const BranchRequest& request,
                                        const std::optional<KeyedRequest>& keyed = {});
  /// Opens the scene where it was evicted, by the journal as at the start.
  Result<std::shared_ptr<Scene>> find(const std::string& id) const;
  Status remove(const std::string& id);
  /// Returns what a request with this path and key made, before a restart too. Its fingerprint may be another one.
  Result<std::optional<RequestedChange>> change_of_request(const KeyedRequest& request) const;
  /// As Journal::health.
  Status health() const;
  /// A line for each scene that is damaged now, and for each that had lost entries when the store was opened.
  std::vector<std::string> damages() const;
  /// Waits for no scene: each is as it was after its last change.
  std::vector<SceneSummary> list() const;
  std::size_t count() const;
  MemoryUse memory() const;
  /// Calls `forget` with SceneView::copy_id of scenes that are evicted or removed. Before anyone else uses the store.
  void on_close(OpenScenes::OnClose forget);
  /// Counts the renderer's copies of scenes into the budget. Before anyone else uses the store.
  void count_copies(OpenScenes::CopyBytes copy_bytes);
  /// The same of baked coats.
  void count_coats(std::function<std::size_t()> coat_bytes);

  /// Reads the bytes through the worker and gives the model to the scene. At most two imports run at a time; more are
  /// refused (busy).
  Result<SceneSummary> load_model(Scene& scene, const ImportOptions& options, std::span<const std::byte> bytes,
                                  const ExecuteOptions& execute = {});

  /// The same with a new version of the scene's model, which takes over its groom (Scene::carry_to) and stands as that
  /// one does. The scene as it was stays as one of its own, which the summary names. Refused: busy at the limit of
  /// scenes.
  Result<SceneSummary> load_version(Scene& scene, const ImportOptions& options, std::span<const std::byte> bytes,
                                    ExecuteOptions execute = {});

  /// Finer triangles for the scene's model, as Scene::subdivide.
  Result<SceneSummary> subdivide(Scene& scene, const Subdivide& how, const ExecuteOptions& execute = {});
  /// Turns the scene's model, as Scene::turn.
  Result<SceneSummary> turn(Scene& scene, const TurnModel& how, const ExecuteOptions& execute = {});

  /// The grooms that the retargets among the commands take, copied before their target is locked. Refused (invalid):
  /// "/scene" where there is no such scene, "/revision" where its model has no such revision; in a batch after
  /// "/commands/K".
  Result<std::vector<GroomSource>> sources_of(const std::vector<Command>& commands) const;
  /// Scene::execute with those grooms.
  Result<CommandAnswer> execute(Scene& scene, const std::vector<Command>& commands, ExecuteOptions options = {}) const;
  /// Scene::amend with them and with those that the scene's log takes.
  Result<CommandAnswer> amend(Scene& scene, const AmendRequest& request, ExecuteOptions options = {}) const;

  /// Reads a picture of all directions through the worker and sets the scene's environment to that of `how` with its
  /// light: a set_environment with harmonics, which needs no picture when it is run again. Counts as an import.
  Result<CommandAnswer> load_environment(Scene& scene, EnvironmentUpload how, std::span<const std::byte> bytes,
                                         const ExecuteOptions& execute = {});

  /// Reads a PNG or JPEG through the worker and lays it on the scene's model. Counts as an import.
  Result<CommandAnswer> load_skin_texture(Scene& scene, std::span<const std::byte> bytes,
                                          const ExecuteOptions& execute = {});
  /// Reads guide curves through the worker and has the fur follow them, as follow_guides.
  Result<CommandAnswer> load_guides(Scene& scene, const GuideUpload& upload, std::span<const std::byte> bytes,
                                    const ExecuteOptions& execute = {});
  /// Keeps the picture and names it in a set_skin_texture. Refused as that command is.
  Result<CommandAnswer> lay_skin_texture(Scene& scene, const RawImage& picture, const ExecuteOptions& execute = {});
  /// Stores a picture of data that commands can name. A picture that no log names is gone after a restart.
  Result<PictureAnswer> keep_picture(std::span<const std::byte> bytes, const Cancel& cancel = {});
  /// The same, and reads a map from it with ApplyMap. Refused as that command is.
  Result<CommandAnswer> load_map(Scene& scene, const MapUpload& upload, std::span<const std::byte> bytes,
                                 const ExecuteOptions& execute = {});

  /// Writes the scene with its model, log and pictures as a file of its own: a journal of one scene. Others change and
  /// read scenes meanwhile. The revision that the file has; unavailable once nobody waits.
  Result<Revision> save(const Scene& scene, const std::string& path, const Cancel& cancel = {}) const;
  /// Makes a scene of such a file as gzip, which anybody may have written; `name` "" for its own. The worker reads it,
  /// its rows are checked in a journal of their own at `scratch`, which is not there yet, and come into the store all
  /// at once. Refused (invalid) when it is none, damaged, or no scene that commands could have made; unavailable once
  /// nobody waits.
  Result<std::shared_ptr<Scene>> open_saved(std::span<const std::byte> bytes, const std::string& scratch,
                                            const std::string& name, const Cancel& cancel = {});

 private:
  struct Impl;
  explicit SceneStore(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace pelage
