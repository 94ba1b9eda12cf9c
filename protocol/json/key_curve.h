// A parameter of a job as a curve over frames, and monotone cubic interpolation between its keys.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/job.h"

namespace pelage::json_parts {

/// The keys of one parameter. Numbers, lists of numbers and colours are interpolated as requested; other values need
/// KeyInterpolation::step.
class KeyCurve {
 public:
  /// Refuses (invalid, with the pointer of the key's value below `pointer`) values that are neither numbers nor lists
  /// of equal length nor colours, unless the interpolation is step.
  static Result<KeyCurve> create(const ParameterKeys& keys, const std::string& pointer);

  /// Returns the value at a frame; between keys, colours are lists of linear red, green and blue.
  nlohmann::json at(double frame) const;

  const nlohmann::json& first() const { return values_.front(); }
  /// Returns a value between keys that has fractions, if all keys are whole numbers and differ; else nullopt. It serves
  /// to test whether the parameter takes fractions.
  std::optional<nlohmann::json> between_integer_keys() const;
  /// Makes all later calls of at() round their values.
  void round_values() { rounded_ = true; }

 private:
  KeyInterpolation interpolation_ = KeyInterpolation::step;
  bool is_list_ = false, rounded_ = false;
  std::vector<double> frames_;
  std::vector<nlohmann::json> values_;
  std::vector<std::vector<double>> numbers_;  // [component][key]; empty with step
};

/// Monotone cubic Hermite interpolation (Fritsch and Carlson 1980) of values at ascending `xs`; `at` lies in the
/// interval that begins at xs[left].
double monotone_cubic(const std::vector<double>& xs, const std::vector<double>& values, std::size_t left, double at);

}  // namespace pelage::json_parts
