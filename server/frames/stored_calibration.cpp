#include "server/frames/stored_calibration.h"

#include <unistd.h>

#include <cassert>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string_view>

#include "protocol/json/calibration.h"

namespace pelage {

extern const std::string_view default_calibration_json;  // made from defaults.json by the build

const Calibration& default_calibration() {
  static const Calibration calibration = [] {
    Result<Calibration> decoded = decode_calibration(default_calibration_json);
    assert(decoded);
    return std::move(decoded).value();
  }();
  return calibration;
}

Result<Calibration> read_calibration(const std::string& path, const std::string& machine, int threads) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return failure(Code::not_found, "There is no calibration " + path + ".");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  Result<Calibration> calibration = decode_calibration(text);
  if (!calibration) {
    const Status& status = calibration.status();
    return failure(Code::invalid, path + " is no calibration of this version: " + status.message, status.pointer,
                   status.limit);
  }
  if (calibration->machine != machine || calibration->threads != threads) {
    return failure(Code::invalid, path + " was measured with " + std::to_string(calibration->threads) + " threads of " +
                                      calibration->machine + ".");
  }
  return calibration;
}

Status write_calibration(const std::string& path, const Calibration& calibration) {
  const std::string temporary = path + "." + std::to_string(getpid());
  std::ofstream file(temporary, std::ios::binary);
  file << encode(calibration) << std::flush;
  if (file && std::rename(temporary.c_str(), path.c_str()) == 0) return {};
  std::remove(temporary.c_str());
  return failure(Code::internal, "Cannot write " + path + ".");
}

}  // namespace pelage
