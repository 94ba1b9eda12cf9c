// The contract between the server and pelage-import: `pelage-import JOB SECONDS BYTES [POSE]`, with the file on
// standard input. The job is a model's format, alone or with "-shape" for a model without its pictures (output:
// encode_raw_model), "environment" (encode_harmonics), "picture" (encode_raw_image), "map" (encode_map_picture), a
// format of guide curves (encode_guides) or "saved" (the rows of an exported scene, server/history/plain_rows.h).
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "base/status.h"
#include "protocol/commands/creature.h"
#include "protocol/commands/guides.h"
#include "protocol/commands/look.h"
#include "protocol/commands/scene.h"
#include "server/surface/mesh.h"

namespace pelage {

/// Indexed by ModelFormat.
inline constexpr std::array<const char*, 8> worker_format_names = {"obj",  "ply", "stl", "off",
                                                                   "gltf", "glb", "3ds", "zip"};

/// Indexed by GuideFormat.
inline constexpr std::array<const char*, 3> worker_guide_names = {"guides-usda", "guides-hair", "guides-json"};

inline constexpr const char* worker_shape = "-shape";
inline constexpr const char* worker_environment = "environment";
inline constexpr const char* worker_picture = "picture";
inline constexpr const char* worker_map = "map";
inline constexpr const char* worker_saved = "saved";

/// The exit codes of the worker. The reason for bad_input is the last line on its standard error.
namespace worker_exit {
inline constexpr int done = 0;
inline constexpr int usage = 2;
inline constexpr int bad_input = 3;
inline constexpr int not_confined = 4;  // the kernel refused a limit or the filter
inline constexpr int out_of_memory = 33;
}  // namespace worker_exit

// Reading uploaded models and pictures through the confined worker pelage-import.

struct ImportLimits {
  double seconds = 60;                              // limit of wall time and of CPU time
  std::size_t memory_bytes = std::size_t{6} << 30;  // address space of the worker
  std::size_t answer_bytes = std::size_t{2} << 30;  // limit of the worker's answer
  std::function<bool()> cancelled = {};             // true ends the worker (unavailable); called four times a second
};

/// Returns the folder of this program, which also has its workers.
std::string program_folder();

/// Runs `worker` (path of pelage-import), sends it `bytes`, reads and validates its answer. Fails (invalid), with the
/// reason, if the worker crashes, exceeds a limit or sends a malformed answer. `pose` is that of ImportOptions.
Result<RawModel> import_model(const std::string& worker, ModelFormat format, std::span<const std::byte> bytes,
                              const std::string& pose = {}, const ImportLimits& limits = {});

/// The same without pictures, which take much of the time: for other poses of a known model.
Result<RawModel> import_shape(const std::string& worker, ModelFormat format, std::span<const std::byte> bytes,
                              const std::string& pose = {});

/// The same for an environment (EXR or HDR of all directions; renderer/light/environment.h). Returns its light.
Result<SphericalHarmonics> import_environment(const std::string& worker, std::span<const std::byte> bytes,
                                              const ImportLimits& limits = {});

/// The same for a skin texture or a backplate (PNG or JPEG).
Result<RawImage> import_picture(const std::string& worker, std::span<const std::byte> bytes,
                                const ImportLimits& limits = {});

/// The same for a file of guide curves.
Result<GuideFile> import_guides(const std::string& worker, GuideFormat format, std::span<const std::byte> bytes,
                                const ImportLimits& limits = {});

/// The same for an exported scene (.pelage): passes its rows to `take` as they arrive. Also fails as `take` does.
using TakeRows = std::function<Status(std::string_view bytes)>;
Status import_saved(const std::string& worker, std::span<const std::byte> bytes, const TakeRows& take,
                    ImportLimits limits = {});

/// The worker's wire format, which the journal also stores. decode checks every count and index. Native byte order.
std::string encode_raw_model(const RawModel& model);
Result<RawModel> decode_raw_model(std::span<const std::byte> bytes);

/// The worker's other answers. Decoding refuses (invalid) numbers beyond limits::harmonic, sides beyond
/// limits::picture_pixels, curves of one point or with numbers that are not finite, and a wrong number of bytes.
std::string encode_harmonics(const SphericalHarmonics& harmonics);
Result<SphericalHarmonics> decode_harmonics(std::span<const std::byte> bytes);
std::string encode_guides(const GuideFile& file);
Result<GuideFile> decode_guides(std::span<const std::byte> bytes);
std::string encode_raw_image(const RawImage& image);
Result<RawImage> decode_raw_image(std::span<const std::byte> bytes);

}  // namespace pelage
