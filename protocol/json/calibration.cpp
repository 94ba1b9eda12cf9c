#include "protocol/json/calibration.h"

#include <cstdio>
#include <cstdlib>

#include "protocol/json/read.h"
#include "protocol/json/write.h"

namespace pelage {

namespace {

/// Six digits are more than any measurement has.
void round(double& number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number);
  number = std::strtod(text, nullptr);
}

Calibration rounded(Calibration calibration) {
  for (double& number : calibration.cost) round(number);
  for (double& number : calibration.low) round(number);
  for (double& number : calibration.high) round(number);
  round(calibration.cost_safety), round(calibration.learnt_safety), round(calibration.probe_safety);
  for (CalibratedKnobs& row : calibration.ladder) {
    round(row.log_error), round(row.error_safety);
    for (double& slope : row.slopes) round(slope);
  }
  return calibration;
}

}  // namespace

std::string encode(const Calibration& calibration) {
  json_parts::Json head = json_parts::written(rounded(calibration));
  const json_parts::Json ladder = std::move(head["ladder"]);
  head.erase("ladder");
  std::string text = json_parts::line(head);
  text.back() = ',';
  text += "\n\"ladder\":[";
  const char* before = "\n";
  for (const json_parts::Json& row : ladder) text += before + json_parts::line(row), before = ",\n";
  return text + "\n]}\n";
}

Result<Calibration> decode_calibration(std::string_view text) { return json_parts::decode_document<Calibration>(text); }

}  // namespace pelage
