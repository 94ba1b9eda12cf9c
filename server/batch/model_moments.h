// Finds the files that have a job's model at a frame.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/job.h"
#include "protocol/commands/scene.h"
#include "server/batch/file_pattern.h"

namespace pelage {

/// The file and pose of a model at one moment in time.
struct ModelMoment {
  std::string file;
  ModelFormat format = ModelFormat::obj;
  std::string pose;    // ImportOptions::pose
  std::string digest;  // of the bytes of the file, and of the next one
  // Between two numbered files: the next one, and its weight, (0, 1).
  std::string next = {};
  double share = 0;
};

class ModelMoments {
 public:
  /// Files are in `folder`. Refused (invalid) with a pointer into the job: a file name with neither frame numbers nor
  /// an animation, or with both; an ending that is not a model's; a loop without an animation.
  static Result<ModelMoments> create(const JobMotion& motion, double fps, const std::string& folder);

  /// Returns the model's moment at a frame or between two. If one of two numbered files is missing, the nearest frame
  /// is used instead. Fails with not_found ("/motion/model") if the nearest frame has no file.
  Result<ModelMoment> at(double frame) const;
  /// Returns a name that depends on the bytes and the pose only; "" if there is no file.
  Result<std::string> name_of(int frame) const;

  /// Returns the moments that the swing of a frame's fur depends on, except those without a file; none without inertia.
  Result<std::vector<ModelMoment>> swing(int frame) const;
  /// Returns a text that identifies all of these moments; "" without inertia.
  Result<std::string> identity_of_swing(int frame) const;
  double inertia() const { return motion_.inertia; }

 private:
  ModelMoments(JobMotion motion, double fps, FilePattern files, ModelFormat format)
      : motion_(std::move(motion)), fps_(fps), files_(std::move(files)), format_(format) {}
  std::string pose_at(double frame) const;
  Result<std::string> digest_of(const std::string& file) const;
  bool is_there(int frame) const;

  JobMotion motion_;
  double fps_;
  FilePattern files_;
  ModelFormat format_;
  mutable std::map<std::string, std::string> digests_;  // by file, so that one with an animation is read once
};

}  // namespace pelage
