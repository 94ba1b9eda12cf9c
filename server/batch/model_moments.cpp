#include "server/batch/model_moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "server/batch/input_file.h"
#include "server/batch/pose_history.h"
#include "server/scene/digest.h"

namespace pelage {

Result<ModelMoments> ModelMoments::create(const JobMotion& motion, double fps, const std::string& folder) {
  Result<FilePattern> files = FilePattern::create(motion.model, folder, "/motion/model");
  if (!files) return files.status();
  const Result<ModelFormat> format = format_of_file(motion.model, "/motion/model");
  if (!format) return format.status();
  if (files->numbered() && !motion.animation.empty())
    return failure(Code::invalid, "Numbered files have no animation.", "/motion/animation", "without #, or none");
  if (!files->numbered() && motion.animation.empty())
    return failure(Code::invalid, "The model would stand still.", "/motion",
                   "# for the digits of the frame, or an animation");
  if (motion.loop_seconds && motion.animation.empty())
    return failure(Code::invalid, "Only an animation begins again.", "/motion/loop_seconds", "with an animation");
  return ModelMoments(motion, fps, std::move(*files), *format);
}

std::string ModelMoments::pose_at(double frame) const {
  if (motion_.animation.empty()) return {};
  double seconds = frame / fps_;
  if (motion_.loop_seconds) seconds -= *motion_.loop_seconds * std::floor(seconds / *motion_.loop_seconds);
  seconds = std::max(0.0, seconds);
  return fmt::format("{}@{:.6f}", motion_.animation, seconds);  // rounded, so that a loop repeats its names
}

Result<std::string> ModelMoments::digest_of(const std::string& file) const {
  std::string& known = digests_[file];
  if (known.empty()) {
    const Result<std::string> bytes = read_file(file);
    if (!bytes) return failure(bytes.status().code, bytes.status().message, "/motion/model");
    known = digest(*bytes);
  }
  return known;
}

bool ModelMoments::is_there(int frame) const {
  std::error_code error;
  return std::filesystem::exists(files_.file(frame), error);
}

Result<ModelMoment> ModelMoments::at(double frame) const {
  const int nearest = static_cast<int>(std::lround(frame)), before = static_cast<int>(std::floor(frame));
  const bool between = files_.numbered() && frame != before && is_there(before) && is_there(before + 1);
  ModelMoment moment{
      .file = files_.file(between ? before : nearest), .format = format_, .pose = pose_at(frame), .digest = {}};
  Result<std::string> digest = digest_of(moment.file);
  if (!digest) return digest.status();
  moment.digest = std::move(*digest);
  if (!between) return moment;
  moment.next = files_.file(before + 1), moment.share = frame - before;
  Result<std::string> next = digest_of(moment.next);
  if (!next) return next.status();
  moment.digest += fmt::format(" {} {:.6f}", *next, moment.share);
  return moment;
}

Result<std::string> ModelMoments::name_of(int frame) const {
  if (!is_there(frame)) return std::string();
  const Result<ModelMoment> moment = at(frame);
  if (!moment) return moment.status();
  return moment->digest + " " + moment->pose;
}

Result<std::vector<ModelMoment>> ModelMoments::swing(int frame) const {
  std::vector<ModelMoment> moments;
  if (!(motion_.inertia > 0)) return moments;
  for (int k = frame - PoseHistory::frames_before(fps_) - 1; k <= frame + 1; ++k) {
    if (!is_there(k)) continue;
    Result<ModelMoment> moment = at(k);
    if (!moment) return moment.status();
    moments.push_back(std::move(*moment));
  }
  return moments;
}

Result<std::string> ModelMoments::identity_of_swing(int frame) const {
  if (!(motion_.inertia > 0)) return std::string();
  std::string identity = fmt::format("{} {}\n", motion_.inertia, fps_);
  for (int k = frame - PoseHistory::frames_before(fps_) - 1; k <= frame + 1; ++k) {
    const Result<std::string> name = name_of(k);
    if (!name) return name.status();
    identity += *name + "\n";
  }
  return identity;
}

}  // namespace pelage
