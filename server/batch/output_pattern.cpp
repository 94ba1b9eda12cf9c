#include "server/batch/output_pattern.h"

#include <filesystem>

namespace pelage {

Result<OutputPattern> OutputPattern::create(const std::string& pattern, const std::string& folder, bool several) {
  const std::string ending = std::filesystem::path(pattern).extension().string();
  if (ending != ".png" && ending != ".exr")
    return failure(Code::invalid, "Frames are written as PNG or EXR, by the ending of the name.", "/output",
                   ".png or .exr");
  Result<FilePattern> files = FilePattern::create(pattern, folder, "/output");
  if (!files) return files.status();
  if (!files->numbered() && several)
    return failure(Code::invalid, "All frames would go to one file.", "/output",
                   "# for the digits of the frame, as fox.####.png");
  return OutputPattern(std::move(*files), ending == ".png" ? FrameFormat::png : FrameFormat::exr);
}

}  // namespace pelage
