// JSON text to commands and requests. Every refusal is a Status whose `pointer` is the JSON pointer of the bad field.
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

// All of these refuse: text that is not JSON, duplicate keys, more than 32 levels, numbers that are no finite double
// (malformed); wrong types, values out of range, missing and unknown names, with the nearest known one (invalid).

/// `{"op": ...}` or `{"commands": [...]}`; 1 to 1,000 commands.
Result<std::vector<Command>> decode_commands(std::string_view text);
Result<NewScene> decode_new_scene(std::string_view text);
/// Decodes a frame request; `usual` is the format of a request that names none.
Result<FrameRequest> decode_frame_request(std::string_view text, FrameFormat usual = FrameFormat::png);
/// A job of pelage-render. Paths and frame ranges are for the batch renderer to check.
Result<RenderJob> decode_job(std::string_view text);

/// Names and values of a query string, decoded.
using Query = std::vector<std::pair<std::string, std::string>>;
/// Decodes the same request from the parameters of an address: width, height, camera (an automatic view) or position,
/// target, up (three numbers with commas) and fov_degrees, quality (a tier) or single knobs, background, exposure,
/// tone_map, view, format, lossy_quality, exr_type, aovs (names with commas), colour_space, overlay, overlay_from,
/// revision. Pointers name the member of the request that the parameter stands for.
Result<FrameRequest> decode_frame_query(const Query& query);
/// How strands are traced: the members of Tracing by their names.
Result<Tracing> decode_tracing_query(const Query& query);
/// How to read a model's bytes: format (required), up, front, length, inclination, fur_patches.
Result<ImportOptions> decode_import_query(const Query& query);

/// What comes with the bytes of an environment's picture: intensity, turn_degrees and colour_space.
Result<EnvironmentUpload> decode_environment_query(const Query& query);
/// Decodes the revisions of a comparison: `from` and `to`, both required.
Result<std::pair<std::uint64_t, std::uint64_t>> decode_compare_query(const Query& query);

/// How fine a mesh: triangles.
Result<MeshRequest> decode_mesh_query(const Query& query);

/// What is exported: format (required), every, widen, curves.
Result<ExportRequest> decode_export_query(const Query& query);

/// `revision`, optional.
Result<std::optional<std::uint64_t>> decode_revision_query(const Query& query);

/// Which map: field (required), format, encoding, size, dilate, scale, units.
Result<MapRequest> decode_map_query(const Query& query);
/// What comes with the bytes of a map: field (required), encoding, scale, units, strength.
Result<MapUpload> decode_map_upload_query(const Query& query);
/// What comes with the bytes of guide curves: format (required), keys, sigma, strength.
Result<GuideUpload> decode_guide_query(const Query& query);

Result<PickRequest> decode_pick(std::string_view text);
/// Reads the parts of the request as texts of JSON; expand_recipe checks what they say.
Result<RecipeRequest> decode_recipe(std::string_view text);

/// `{"steps": n}` (1 when absent or the body is empty), n in [1, 1e6].
Result<int> decode_steps(std::string_view text);
/// `{"revision": n}`.
Result<std::uint64_t> decode_revision(std::string_view text);

/// `{"levels": n, "masked": false}`; both have defaults, and the body may be empty.
Result<Subdivide> decode_subdivide(std::string_view text);
/// `{"up": "z", "front": "-y"}`; both have defaults.
Result<TurnModel> decode_turn_model(std::string_view text);
Result<SceneName> decode_scene_name(std::string_view text);
/// `{"name": ..., "revision": n}`, both optional; an empty body is {}.
Result<BranchRequest> decode_branch(std::string_view text);
/// `{"revision": n, "commands": [...]}`, both required; 0 to 1,000 commands.
Result<AmendRequest> decode_amend(std::string_view text);

// How a client reads the server's answers. It ignores unknown members and words, and accepts limits that have grown, so
// that an older client still works.

/// Decodes an answer. Refuses (malformed, with the pointer of the bad member) anything else. T is a struct that
/// encode.h makes an answer of.
template <class T>
Result<T> decode_answer(std::string_view text);

/// The refusal in a problem document; its code follows the `type`. Malformed when it is no problem document.
Status decode_problem(std::string_view text);

}  // namespace pelage
