#include "protocol/json/calibration.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "protocol/json/encode.h"
#include "protocol/json/parse.h"
#include "protocol/json/read.h"

namespace pelage {

namespace {

using nlohmann::json;

constexpr int version = 3;  // of the cost terms and error traits
constexpr Range price{0, 1e9};
constexpr Range safety{1, 100};
constexpr Range exponent{-100, 100};
constexpr std::size_t max_rows = 256;

template <std::size_t N>
void read_numbers(const Value& value, Range range, std::array<double, N>& out) {
  const std::vector<Value> members = value.list(N, N);
  for (std::size_t i = 0; i < std::min(N, members.size()); ++i) out[i] = members[i].number(range);
}

CalibratedKnobs row_of(const Value& value) {
  CalibratedKnobs row;
  Object object(value);
  object.required("knobs", [&](const Value& v) { row.knobs = json_parts::quality(v); });
  object.required("log_error", [&](const Value& v) { row.log_error = v.number(exponent); });
  object.required("slopes", [&](const Value& v) { read_numbers(v, exponent, row.slopes); });
  object.required("error_safety", [&](const Value& v) { row.error_safety = v.number(safety); });
  object.finish();
  if (row.knobs.method != Method::shells) value.refuse_below("knobs/method", "The ladder is of shells.", "shells");
  return row;
}

Calibration calibration_of(const Value& value) {
  Calibration result;
  Object object(value);
  object.required("version", [&](const Value& v) { v.integer({version, version}); });
  object.required("name", [&](const Value& v) { result.name = v.text(1, limits::name_bytes); });
  object.required("machine", [&](const Value& v) { result.machine = v.text(0, limits::name_bytes); });
  object.required("threads", [&](const Value& v) { result.threads = static_cast<int>(v.integer({0, 65536})); });
  object.required("cost", [&](const Value& v) { read_numbers(v, price, result.cost); });
  object.required("cost_safety", [&](const Value& v) { result.cost_safety = v.number(safety); });
  object.required("learnt_safety", [&](const Value& v) { result.learnt_safety = v.number(safety); });
  object.required("probe_safety", [&](const Value& v) { result.probe_safety = v.number(safety); });
  object.required("low", [&](const Value& v) { read_numbers(v, {-1e6, 1e6}, result.low); });
  object.required("high", [&](const Value& v) { read_numbers(v, {-1e6, 1e6}, result.high); });
  object.required("ladder", [&](const Value& v) {
    for (const Value& member : v.list(1, max_rows)) result.ladder.push_back(row_of(member));
  });
  object.finish();
  return result;
}

/// Six digits are more than any measurement has.
double rounded(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", number);
  return std::strtod(text, nullptr);
}

template <std::size_t N>
json rounded(const std::array<double, N>& numbers) {
  json list = json::array();
  for (const double number : numbers) list.push_back(rounded(number));
  return list;
}

}  // namespace

std::string encode(const Calibration& calibration) {
  const nlohmann::ordered_json head = {{"version", version},
                                       {"name", calibration.name},
                                       {"machine", calibration.machine},
                                       {"threads", calibration.threads},
                                       {"cost", rounded(calibration.cost)},
                                       {"cost_safety", rounded(calibration.cost_safety)},
                                       {"learnt_safety", rounded(calibration.learnt_safety)},
                                       {"probe_safety", rounded(calibration.probe_safety)},
                                       {"low", rounded(calibration.low)},
                                       {"high", rounded(calibration.high)}};
  std::string text = head.dump(-1, ' ', false, json::error_handler_t::replace);
  text.back() = ',';
  text += "\n\"ladder\":[";
  const char* before = "\n";
  for (const CalibratedKnobs& row : calibration.ladder) {
    const nlohmann::ordered_json line = {{"log_error", rounded(row.log_error)},
                                         {"slopes", rounded(row.slopes)},
                                         {"error_safety", rounded(row.error_safety)},
                                         {"knobs", nlohmann::ordered_json::parse(encode(row.knobs))}};
    text += before + line.dump();
    before = ",\n";
  }
  return text + "\n]}\n";
}

Result<Calibration> decode_calibration(std::string_view text) {
  const Result<json> document = parse_json(text);
  if (!document) return document.status();
  Status first_failure;
  Calibration calibration = calibration_of(Value(*document, "", first_failure));
  if (!first_failure.ok()) return first_failure;
  return calibration;
}

}  // namespace pelage
