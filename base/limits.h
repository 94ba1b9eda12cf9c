// All limits of the contract. tests/end_to_end/service/test_contract.py checks those that the contract repeats.
#pragma once

#include <cstddef>
#include <cstdint>

namespace pelage::limits {

inline constexpr std::size_t command_body_bytes = std::size_t{1} << 20;
inline constexpr std::size_t recipe_bytes = std::size_t{8} << 20;  // including the files that it includes
inline constexpr std::size_t file_name_bytes = 4096;
inline constexpr std::size_t model_bytes = std::size_t{256} << 20;
inline constexpr std::size_t model_triangles = 2'000'000;
inline constexpr double frame_seconds = 86'400;
inline constexpr std::size_t numbered_parts = 1'000;
inline constexpr std::size_t picture_bytes = std::size_t{128} << 20;  // size of an uploaded picture
inline constexpr int picture_pixels = 4096;                           // width and height of an uploaded picture, each
inline constexpr int map_pixels = 8192;                               // side of a map that the server draws
inline constexpr int map_dilation = 64;                               // pixels
inline constexpr double harmonic = 1e6;                               // magnitude of an environment's coefficient
inline constexpr std::size_t saved_bytes = std::size_t{2} << 30;      // size of a .pelage file, decompressed
inline constexpr double export_strands = 4e6;                         // strands of a file, about 160 bytes each
inline constexpr int proxy_triangles = 200'000;                       // triangles of a mesh for clients (MeshRequest)
inline constexpr double proxy_size = 1e-30;                           // smallest size of a model with such a mesh
inline constexpr std::size_t builtin_triangles = 1'000'000;
inline constexpr std::size_t commands_per_batch = 1'000;
inline constexpr double evaluation_visits = 5e8;  // visits of vertices by one request (evaluation_cost.h)
inline constexpr std::size_t samples_per_stroke = 10'000;
inline constexpr std::size_t dabs_per_stroke = 100'000;  // length of the stroke over spacing x radius
inline constexpr std::size_t falloff_points = 64;
inline constexpr std::size_t guide_bytes = std::size_t{64} << 20;
inline constexpr std::size_t keys = 1024;  // keys of one interpolation
inline constexpr std::size_t flow_curves = 64;
inline constexpr std::size_t flow_points = 256;        // points of each curve
inline constexpr int passes = 10'000;                  // passes of smoothing
inline constexpr std::size_t mask_vertices = 100'000;  // vertices named in one mask command
inline constexpr std::size_t named_materials = 256;    // named materials of a model
inline constexpr std::size_t blowers = 64;             // the same for attractors
inline constexpr std::size_t coats = 8;                // coats of a scene
inline constexpr std::size_t edit_layers = 14;
inline constexpr double min_groomed_weight = 0.05;  // smallest |weight| of an edit layer that tools can change
inline constexpr std::size_t symmetry_planes = 3;
inline constexpr int symmetry_images = 16;  // images of a rotation
inline constexpr double min_sigma = 1e-6;   // smallest width of a Gaussian, sizes
inline constexpr double fur_length = 10;    // sizes
inline constexpr int subdivide_levels = 8;
inline constexpr std::size_t scenes = 64;
inline constexpr std::size_t undo_bytes = std::size_t{256} << 20;  // memory for a scene's undo steps
inline constexpr std::size_t name_bytes = 200;
inline constexpr std::size_t path_bytes = 4096;
inline constexpr int json_depth = 32;
inline constexpr double model_coordinate = 1e20;
inline constexpr double command_coordinate_sizes = 1e6;  // largest coordinate in a command, sizes of the model
inline constexpr double model_precision = 1e-4;          // largest step of 32-bit coordinates, sizes of the model
inline constexpr int shells = 1024;
inline constexpr int frame_pixels = 8192;               // width and height, each
inline constexpr int job_tiles = 16;                    // tiles of a job's frame in each direction
inline constexpr std::int64_t aov_pixels = 67'108'864;  // drawn pixels times AOVs of an EXR: 1 GB on the GPU
inline constexpr int trace_passes = 65536;
inline constexpr int strands = 8'000'000;                        // traced strands
inline constexpr std::int64_t sorted_fragments = 1'073'741'824;  // drawn pixels times shells of a sorted frame
inline constexpr double time_seconds = 1e6;                      // largest magnitude of a scene's time
inline constexpr double wind_speed = 1e6;                        // sizes per second
inline constexpr std::size_t lights = 8;
inline constexpr std::size_t eyes = 8;
inline constexpr double min_eye_radius = 1e-6;  // sizes
inline constexpr std::size_t curve_groups = 16;
inline constexpr std::size_t curves = 4096;  // curves of all groups, filled ones included
inline constexpr std::size_t curve_points = 32;
inline constexpr std::size_t skin_regions = 64;
inline constexpr double min_skin_radius = 1e-6;  // sizes
inline constexpr std::size_t ramp_stops = 4;
inline constexpr double wait_seconds = 25.0;

}  // namespace pelage::limits
