// A model with the files that it refers to.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/status.h"
#include "protocol/commands/scene.h"

namespace pelage {

struct BundledFile {
  std::string path;  // relative to the root of the bundle, with slashes
  std::string bytes;
};

/// The content of an upload: one model, and the files beside it.
class Bundle {
 public:
  /// Makes a bundle of a model alone.
  explicit Bundle(std::string model) : files_{{"model", std::move(model)}} {}

  /// Unpacks a zip archive with one model, and sets `format` to the model's format. Refused (invalid) if the archive is
  /// broken, needs a password, has no model or several, or unpacks to more than four times limits::model_bytes.
  static Result<Bundle> unpack(const std::string& zip, ModelFormat& format);

  const std::string& path() const { return files_.front().path; }
  std::string& model() { return files_.front().bytes; }
  bool has_others() const { return files_.size() > 1; }

  /// Makes readers skip pictures, without counting them as missing.
  void leave_pictures_out() { with_pictures_ = false; }
  bool with_pictures() const { return with_pictures_; }

  /// Returns the file that the model calls by this name: a path from the model's folder, percent-encoded or not, with
  /// slashes or backslashes. If no path fits, returns the only file of that name in any case and folder. Null if there
  /// is none.
  const std::string* find(std::string_view name) const;

 private:
  Bundle() = default;
  std::vector<BundledFile> files_;  // the model comes first
  bool with_pictures_ = true;
};

}  // namespace pelage
