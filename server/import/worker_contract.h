// What the server and pelage-import agree on: `pelage-import JOB SECONDS BYTES`, bytes in. The job is a model's format
// (encode_raw_model out), "environment" (encode_harmonics out), "picture" (encode_raw_image out) or "map" (encode_map_picture
// out).
#pragma once

#include <array>

namespace pelage {

/// By ModelFormat.
inline constexpr std::array<const char*, 7> worker_format_names = {"obj", "ply", "stl", "off", "gltf", "glb", "3ds"};

inline constexpr const char* worker_environment = "environment";
inline constexpr const char* worker_picture = "picture";
inline constexpr const char* worker_map = "map";

/// How the worker ends. The reason for bad_input is the last line on its standard error.
namespace worker_exit {
inline constexpr int done = 0;
inline constexpr int usage = 2;
inline constexpr int bad_input = 3;
inline constexpr int not_confined = 4;  // the kernel refused a limit or the filter
inline constexpr int out_of_memory = 33;
}  // namespace worker_exit

}  // namespace pelage
