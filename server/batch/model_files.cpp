#include "server/batch/model_files.h"

#include <set>
#include <span>

#include "server/batch/input_file.h"
#include "server/import/import.h"

namespace pelage {

namespace {

/// Reads `file`, which is the first or the second file of the moment.
Result<RawModel> read_shape(const MovingModel& moving, const ModelMoment& moment, const std::string& file) {
  const auto refused = [&](const Status& status) {
    return in_file(file, failure(status.code, status.message, "/motion/model", status.limit));
  };
  const Result<std::string> bytes = read_file(file);
  if (!bytes) return failure(bytes.status().code, bytes.status().message, "/motion/model");
  Result<RawModel> raw =
      import_shape(program_folder() + "/pelage-import", moment.format, std::as_bytes(std::span(*bytes)), moment.pose);
  if (!raw) return refused(raw.status());
  if (Status other = moving.check(*raw); !other.ok()) return refused(other);
  return raw;
}

/// Checks files by reading each of them once.
class FileCheck {
 public:
  explicit FileCheck(MovingModel moving) : moving_(std::move(moving)) {}

  Status check(const ModelMoment& moment) {
    for (const std::string& file : {moment.file, moment.next}) {
      if (file.empty() || !read_.insert(file).second) continue;
      if (const Result<RawModel> raw = read_shape(moving_, moment, file); !raw) return raw.status();
    }
    return {};
  }

 private:
  const MovingModel moving_;
  std::set<std::string> read_;
};

Status check_files_of(const JobFrame& frame, FileCheck& files) {
  const Result<std::vector<ModelMoment>> swing = frame.motion->swing(frame.number);
  if (!swing) return swing.status();
  std::vector<ModelMoment> moments = *swing;
  moments.push_back(*frame.moment.model);
  for (const JobMoment& moment : frame.shutter_moments) moments.push_back(*moment.model);
  for (const ModelMoment& moment : moments) {
    if (Status refused = files.check(moment); !refused.ok()) return refused;
  }
  return {};
}

}  // namespace

Result<RawModel> read_model(const MovingModel& moving, const ModelMoment& moment) {
  Result<RawModel> model = read_shape(moving, moment, moment.file);
  if (!model || moment.next.empty()) return model;
  const Result<RawModel> next = read_shape(moving, moment, moment.next);
  if (!next) return next;
  for (std::size_t v = 0; v < model->positions.size(); ++v)
    model->positions[v] = glm::mix(model->positions[v], next->positions[v], moment.share);
  return model;
}

Status check_models(const JobScene& scene, const std::vector<JobFrame>& frames, const std::function<bool()>& stopped) {
  if (frames.empty() || !frames.front().motion) return {};
  Result<MovingModel> moving = scene.moving_model();
  if (!moving) return moving.status();
  FileCheck files(std::move(*moving));
  for (const JobFrame& frame : frames) {
    if (stopped()) return failure(Code::unavailable, "stopped before the job was checked");
    if (Status refused = check_files_of(frame, files); !refused.ok()) return refused;
  }
  return {};
}

}  // namespace pelage
