// Decodes commands and requests from JSON text or query parameters, and answers for clients. Every refusal is a Status
// whose `pointer` is the JSON pointer of the bad field.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/status.h"
#include "protocol/commands/answers.h"
#include "protocol/commands/command.h"
#include "protocol/commands/export.h"
#include "protocol/commands/frame.h"
#include "protocol/commands/guides.h"
#include "protocol/commands/history.h"
#include "protocol/commands/job.h"
#include "protocol/commands/map.h"
#include "protocol/commands/pick.h"
#include "protocol/commands/quality.h"
#include "protocol/commands/recipe.h"
#include "protocol/commands/scene.h"
#include "protocol/commands/settings.h"

namespace pelage {

// All of these functions refuse text that is not JSON, duplicate keys, more than 32 levels and numbers that are no
// finite double (malformed), and wrong types, values out of range, missing and unknown names, with the nearest known
// one (invalid).

/// Decodes `{"op": ...}` or `{"commands": [...]}`; 1 to 1,000 commands.
Result<std::vector<Command>> decode_commands(std::string_view text);
Result<NewScene> decode_new_scene(std::string_view text);
/// Decodes a frame request; `usual` is the format of a request that names none.
Result<FrameRequest> decode_frame_request(std::string_view text, FrameFormat usual = FrameFormat::png);
/// Decodes a job of pelage-render. The batch renderer checks paths and frame ranges.
Result<RenderJob> decode_job(std::string_view text);

/// Decoded names and values of a query string.
using Query = std::vector<std::pair<std::string, std::string>>;
/// Decodes a frame request from query parameters: the members of FrameRequest by their names, lists with commas.
/// Members of the camera, the knobs and their `raster` are parameters themselves; `camera` and `quality` take an
/// automatic view and a tier, and of the look there is only colour_source. Crop is left,top,width,height. `trace`,
/// `shells` and `progressive` are not available. Pointers name the member of the request that the parameter stands for.
Result<FrameRequest> decode_frame_query(const Query& query);
/// Decodes how strands are traced: the members of Tracing by their names.
Result<Tracing> decode_tracing_query(const Query& query);
/// Decodes how a model file is read: the members of ImportOptions and of its first groom; format is required.
Result<ImportOptions> decode_import_query(const Query& query);

/// Decodes the parameters of an environment's picture: intensity, turn_degrees and colour_space.
Result<EnvironmentUpload> decode_environment_query(const Query& query);
/// Decodes the revisions of a comparison: `from` and `to`, both required.
Result<std::pair<std::uint64_t, std::uint64_t>> decode_compare_query(const Query& query);

/// Decodes the members of MeshRequest.
Result<MeshRequest> decode_mesh_query(const Query& query);

/// Decodes the members of ExportRequest; format is required.
Result<ExportRequest> decode_export_query(const Query& query);

/// Decodes `revision`, which is optional.
Result<std::optional<std::uint64_t>> decode_revision_query(const Query& query);

/// Decodes the members of MapRequest; field is required.
Result<MapRequest> decode_map_query(const Query& query);
/// Decodes the members of MapUpload; field is required.
Result<MapUpload> decode_map_upload_query(const Query& query);
/// Decodes the members of GuideUpload; format is required.
Result<GuideUpload> decode_guide_query(const Query& query);

Result<PickRequest> decode_pick(std::string_view text);
/// Keeps the parts of the request as JSON texts; expand_recipe checks their contents.
Result<RecipeRequest> decode_recipe(std::string_view text);

/// Decodes `{"steps": n}`, n in [1, 1e6]; 1 if absent or if the body is empty.
Result<int> decode_steps(std::string_view text);
/// Decodes `{"revision": n}`.
Result<std::uint64_t> decode_revision(std::string_view text);

/// Decodes `{"levels": n, "masked": false}`; both have defaults, and the body may be empty.
Result<Subdivide> decode_subdivide(std::string_view text);
/// Decodes `{"up": "z", "front": "-y"}`; both have defaults, and the body may be empty.
Result<TurnModel> decode_turn_model(std::string_view text);
Result<SceneName> decode_scene_name(std::string_view text);
/// Decodes `{"name": ..., "revision": n}`; both are optional, and the body may be empty.
Result<BranchRequest> decode_branch(std::string_view text);
/// Decodes `{"revision": n, "commands": [...]}`, both required; 0 to 1,000 commands.
Result<AmendRequest> decode_amend(std::string_view text);

// Answers of the server, decoded for clients. Unknown members and words are ignored, and values beyond known limits are
// accepted, so that an older client still works.

/// Decodes an answer. T is one of the answers that encode.h encodes. Refuses (malformed, with the pointer of the bad
/// member) anything else.
template <class T>
Result<T> decode_answer(std::string_view text);

/// Returns the refusal in a problem document; its code follows from the `type`. Malformed if it is not a problem
/// document.
Status decode_problem(std::string_view text);

}  // namespace pelage
