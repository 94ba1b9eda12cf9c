#include "server/batch/output_file.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <limits>
#include <span>

#include "base/limits.h"
#include "base/temporary_name.h"
#include "base/version/version.h"
#include "protocol/json/encode.h"
#include "protocol/json/names.h"
#include "renderer/picture_files/picture_files.h"
#include "server/batch/input_file.h"

namespace pelage {

namespace {

Status cannot_write(const std::string& path, int error) {
  return with_next(failure(Code::internal, path + " cannot be written: " + std::strerror(error) + "."),
                   "see that its folder can be written and has room");
}

/// Writes all bytes and syncs them. Returns 0, or errno if that fails.
int write_synced(const std::string& path, std::string_view bytes) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int error = 0;
  while (!bytes.empty() && error == 0) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written >= 0) bytes.remove_prefix(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) error = errno;
  }
  if (error == 0 && ::fsync(file) != 0) error = errno;
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

std::string text_of(const Camera& camera) {
  if (camera.automatic != AutoView::none)
    return std::string(json_names::text_of(json_names::auto_views, camera.automatic));
  const auto list = [](glm::dvec3 v) { return fmt::format("{:.6g} {:.6g} {:.6g}", v.x, v.y, v.z); };
  return fmt::format("position {}, target {}, up {}, fov {:.6g}", list(camera.position), list(camera.target),
                     list(camera.up), camera.fov_degrees);
}

/// Returns the rate as a ratio of whole numbers, as EXR requires.
std::string ratio_of(double fps) {
  return fps == std::floor(fps) ? fmt::format("{:.0f}/1", fps) : fmt::format("{:.0f}/1000", fps * 1000);
}

}  // namespace

Status write_atomically(const std::string& path, std::string_view bytes) {
  const std::filesystem::path target(path);
  std::error_code error;
  if (target.has_parent_path()) std::filesystem::create_directories(target.parent_path(), error);
  const std::string temporary = temporary_beside(path);
  int failed = write_synced(temporary, bytes);
  if (failed == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) failed = errno;
  if (failed == 0) return {};
  ::unlink(temporary.c_str());
  return cannot_write(path, failed);
}

Status check_folder_writable(const std::string& path) {
  const std::filesystem::path target = std::filesystem::absolute(path);
  std::filesystem::path folder = target.parent_path();
  std::error_code error;
  while (!std::filesystem::exists(folder, error) && folder.has_relative_path()) folder = folder.parent_path();
  const std::string temporary = temporary_beside((folder / target.filename()).string());
  const int failed = write_synced(temporary, {});
  if (failed == 0) ::unlink(temporary.c_str());
  return failed == 0 ? Status{} : cannot_write(path, failed);
}

bool is_drawn(const std::string& path, const std::string& fingerprint) {
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return false;
  constexpr std::size_t max_pixels = std::size_t{limits::frame_pixels} * limits::frame_pixels;
  const auto picture = picture_files().decode_data_image(std::as_bytes(std::span(*bytes)), max_pixels, fingerprint_key);
  return picture && picture->text == fingerprint;
}

std::vector<ImageText> metadata_of(const JobFrame& frame, const std::string& quality, const SceneSummary& scene,
                                   double fps, double seconds) {
  std::vector<ImageText> texts{
      {"Software", std::string("pelage-render ") + version()},
      {"pelage/frame", std::to_string(frame.number)},
      {"pelage/revision", std::to_string(frame.moment.request.revision.value_or(scene.revision))},
      {"pelage/fieldsHash", to_hex(scene.fields_hash)},
      {quality_key, quality},
      {"pelage/camera", text_of(frame.moment.request.camera)},
      {fingerprint_key, frame.fingerprint}};
  if (frame.moment.request.format != FrameFormat::exr) {
    texts.push_back(
        {"pelage/request", encode(frame.moment.request)});  // ffmpeg 5.1 cannot handle so long a text in an EXR
    return texts;
  }
  const std::time_t now = std::time(nullptr);
  texts.push_back({"DateTime", fmt::format("{:%Y:%m:%d %H:%M:%S}", fmt::gmtime(now))});
  texts.push_back({"HostComputer", host_name()});
  texts.push_back({frame_rate_text, ratio_of(fps)});
  texts.push_back({render_time_key, fmt::format("{:.3f}", seconds)});
  return texts;
}

}  // namespace pelage
