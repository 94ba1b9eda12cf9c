// Names of files that are numbered by the frame.
#pragma once

#include <string>

#include "base/status.h"

namespace pelage {

class FilePattern {
 public:
  /// `pattern` as "out/fox.####.exr": # are the digits of the frame; one that begins with no / lies below `folder`.
  /// Refused (invalid, `pointer`): several runs of #, # in the name of a folder.
  static Result<FilePattern> create(const std::string& pattern, const std::string& folder, const std::string& pointer);

  /// At least as many digits as there are #; a minus comes before them.
  std::string file(int frame) const;
  bool numbered() const { return digits_ > 0; }

 private:
  std::string before_, after_;
  std::size_t digits_ = 0;
};

}  // namespace pelage
