// Names of the files that frames go to.
#pragma once

#include <string>

#include "protocol/base/status.h"
#include "protocol/commands/frame.h"

namespace pelage {

class OutputPattern {
 public:
  /// `pattern` as "out/fox.####.exr"; one that begins with no / lies below `folder`. Refused (invalid): an ending that
  /// is neither .png nor .exr, several runs of #, none where there are `several` frames, no name before the ending.
  static Result<OutputPattern> create(const std::string& pattern, const std::string& folder, bool several);

  /// At least as many digits as there are #; a minus comes before them.
  std::string file(int frame) const;
  FrameFormat format() const { return format_; }  // png or exr

 private:
  std::string before_, after_;
  std::size_t digits_ = 0;
  FrameFormat format_ = FrameFormat::png;
};

}  // namespace pelage
