#include "protocol/json/calibration.h"

#include "protocol/json/read.h"
#include "protocol/json/write.h"

namespace pelage {

std::string encode(const Calibration& calibration) { return json_parts::line(json_parts::written(calibration)) + "\n"; }

Result<Calibration> decode_calibration(std::string_view text) { return json_parts::decode_document<Calibration>(text); }

}  // namespace pelage
