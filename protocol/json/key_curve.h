// A parameter of a job as a curve over frames, and monotone cubic interpolation between its keys.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/status.h"
#include "protocol/commands/job.h"

namespace pelage::json_parts {

/// The keys of one parameter: numbers and lists of numbers, interpolated as asked; any other value steps.
class KeyCurve {
 public:
  /// Refused (invalid, with the pointer of the key's value below `pointer`): values that are neither numbers nor lists
  /// of as many numbers nor colours, unless they step.
  static Result<KeyCurve> create(const ParameterKeys& keys, const std::string& pointer);

  /// Returns the value at a frame; between keys, colours are lists of linear red, green and blue.
  nlohmann::json at(double frame) const;

  const nlohmann::json& first() const { return values_.front(); }
  /// Returns a value with fractions between keys that are whole numbers; none where they are not, or never change.
  std::optional<nlohmann::json> between_whole_keys() const;
  /// Rounds the values of all later calls of at().
  void keep_whole() { whole_ = true; }

 private:
  KeyInterpolation interpolation_ = KeyInterpolation::step;
  bool is_list_ = false, whole_ = false;
  std::vector<double> frames_;
  std::vector<nlohmann::json> values_;
  std::vector<std::vector<double>> numbers_;  // of each component, its keys; unless it steps
};

/// Monotone cubic Hermite interpolation (Fritsch and Carlson 1980) of values at ascending places; `at` lies in the
/// interval that begins at place `left`.
double monotone_cubic(const std::vector<double>& places, const std::vector<double>& values, std::size_t left,
                      double at);

}  // namespace pelage::json_parts
