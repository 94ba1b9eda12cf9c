// A model with the files that it names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "protocol/commands/scene.h"

namespace pelage {

struct BundledFile {
  std::string path;  // with slashes, from where the bundle begins
  std::string bytes;
};

/// The content of an upload: one model, and the files beside it.
class Bundle {
 public:
  /// A model alone.
  explicit Bundle(std::string model) : files_{{"model", std::move(model)}} {}

  /// Unpacks a zip archive, the one model in which comes first; `format` is set to its own. Refused (invalid) when the
  /// archive is broken, needs a password, has no model or several, or is larger than a model may be, unpacked four
  /// times as large.
  static Result<Bundle> unpack(const std::string& zip, ModelFormat& format);

  const std::string& path() const { return files_.front().path; }
  std::string& model() { return files_.front().bytes; }
  bool has_others() const { return files_.size() > 1; }

  /// Makes readers leave out pictures, without counting them as missing.
  void leave_pictures_out() { with_pictures_ = false; }
  bool with_pictures() const { return with_pictures_; }

  /// The file that the model calls by this name: from its own folder, percent-encoded or not, with either slash; where
  /// no path fits, the only file of that name, whatever its case and folder. Null where there is none.
  const std::string* find(std::string_view name) const;

 private:
  Bundle() = default;
  std::vector<BundledFile> files_;  // the model first
  bool with_pictures_ = true;
};

}  // namespace pelage
