// Names of the files to which frames are written.
#pragma once

#include <string>

#include "base/status.h"
#include "protocol/commands/frame.h"
#include "server/batch/file_pattern.h"

namespace pelage {

class OutputPattern {
 public:
  /// Like FilePattern::create. Also refused (invalid): an ending that is neither .png nor .exr, and no # if there are
  /// `several` frames.
  static Result<OutputPattern> create(const std::string& pattern, const std::string& folder, bool several);

  std::string file(int frame) const { return pattern_.file(frame); }
  FrameFormat format() const { return format_; }  // png or exr

 private:
  OutputPattern(FilePattern pattern, FrameFormat format) : pattern_(std::move(pattern)), format_(format) {}

  FilePattern pattern_;
  FrameFormat format_;
};

}  // namespace pelage
