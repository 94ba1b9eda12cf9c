// Names of files with the number of a frame.
#pragma once

#include <string>

#include "base/status.h"

namespace pelage {

class FilePattern {
 public:
  /// `pattern` is for example "out/fox.####.exr", with # for the digits of the frame; a relative one is below `folder`.
  /// Refused (invalid, `pointer`): several runs of #, or # in the name of a folder.
  static Result<FilePattern> create(const std::string& pattern, const std::string& folder, const std::string& pointer);

  /// Returns the file of a frame: at least as many digits as the pattern has #, after a minus sign if it is negative.
  std::string file(int frame) const;
  bool numbered() const { return digits_ > 0; }

 private:
  std::string before_, after_;
  std::size_t digits_ = 0;
};

}  // namespace pelage
