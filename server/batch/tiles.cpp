#include "server/batch/tiles.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <span>

#include "renderer/picture_files/picture_files.h"
#include "server/batch/input_file.h"
#include "server/batch/output_file.h"
#include "server/scene/digest.h"

namespace pelage {

namespace {

/// Returns "out/fox.0001.tile3.png" for "out/fox.0001.png" and 3.
std::string tile_file(const std::string& file, int number) {
  std::filesystem::path path(file);
  const std::string ending = path.extension().string();
  return path.replace_extension(".tile" + std::to_string(number) + ending).string();
}

Status check_frame(const TileGrid& grid, const FrameRequest& request) {
  if (request.crop)
    return failure(Code::invalid, "A frame that is cut into tiles has no crop.", "/frame/crop", "without tiles");
  if (request.budget_ms)
    return failure(Code::invalid, "A budget depends on the machine, and the tiles would not fit together.",
                   "/frame/budget_ms", "quality or max_error");
  if (request.knobs.method == Method::strands && request.knobs.trace.seconds > 0)
    return failure(Code::invalid, "An end by seconds depends on the machine, and the tiles would not fit together.",
                   "/frame/quality/trace/seconds", "0");
  if (grid.columns > request.width || grid.rows > request.height)
    return failure(
        Code::invalid, "The frame has fewer pixels than tiles.", "/tiles",
        "columns at most " + std::to_string(request.width) + ", rows at most " + std::to_string(request.height));
  return {};
}

/// Returns the sum of the render times in the tiles' metadata; 0 if there are none.
double seconds_of(const std::vector<PicturePart>& parts) {
  double seconds = 0;
  for (const PicturePart& part : parts)
    seconds += std::strtod(
        picture_files().text_in_picture(std::as_bytes(std::span(part.bytes)), render_time_key).c_str(), nullptr);
  return seconds;
}

/// Reads the files of all tiles; none if one is missing or has another fingerprint.
std::optional<std::vector<PicturePart>> read_parts(const JobFrame& frame) {
  std::vector<PicturePart> parts;
  for (const JobTile& tile : frame.tiles) {
    Result<std::string> bytes = read_file(tile.file);
    if (!bytes ||
        picture_files().text_in_picture(std::as_bytes(std::span(*bytes)), fingerprint_key) != tile.fingerprint)
      return {};
    parts.push_back({std::move(*bytes), tile.crop.left, tile.crop.top});
  }
  return parts;
}

}  // namespace

Result<std::vector<JobTile>> tiles_of(const TileGrid& grid, const JobFrame& frame) {
  const FrameRequest& request = frame.moment.request;
  if (Status refused = check_frame(grid, request); !refused.ok()) return refused;
  std::vector<JobTile> tiles;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const int left = request.width * column / grid.columns, right = request.width * (column + 1) / grid.columns;
      const int top = request.height * row / grid.rows, bottom = request.height * (row + 1) / grid.rows;
      const int number = static_cast<int>(tiles.size()) + 1;
      const std::string part =
          std::to_string(left) + " " + std::to_string(top) + " " + std::to_string(right) + " " + std::to_string(bottom);
      tiles.push_back({number,
                       {left, top, right - left, bottom - top},
                       tile_file(frame.file, number),
                       digest(frame.fingerprint + "\n" + part)});
    }
  }
  return tiles;
}

Result<bool> merge_tiles(const JobFrame& frame, const SceneSummary& scene, double fps) {
  const std::optional<std::vector<PicturePart>> parts = read_parts(frame);
  if (!parts) return false;
  const std::string quality =
      picture_files().text_in_picture(std::as_bytes(std::span(parts->front().bytes)), quality_key);
  const std::vector<ImageText> texts = metadata_of(frame, quality, scene, fps, seconds_of(*parts));
  const FrameRequest& request = frame.moment.request;
  const bool keep_alpha = request.background == Background::transparent;
  const Result<std::string> merged =
      picture_files().merge_pictures(*parts, request.width, request.height, keep_alpha, texts);
  if (!merged) return merged.status();
  if (Status written = write_atomically(frame.file, *merged); !written.ok()) return written;
  remove_tiles(frame);
  return true;
}

void remove_tiles(const JobFrame& frame) {
  for (const JobTile& tile : frame.tiles) ::unlink(tile.file.c_str());
}

}  // namespace pelage
