#include "protocol/json/key_curve.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "protocol/json/colour.h"

namespace pelage::json_parts {

namespace {

/// Returns the components of a value; nullopt if it cannot be interpolated.
std::optional<std::vector<double>> numbers_of(const nlohmann::json& value) {
  if (value.is_number()) return std::vector{value.get<double>()};
  if (value.is_string()) {
    const auto colour = colour_of_text(value.get_ref<const std::string&>());
    if (!colour) return {};
    return std::vector<double>{colour->r, colour->g, colour->b};
  }
  if (!value.is_array() || !std::ranges::all_of(value, [](const auto& v) { return v.is_number(); })) return {};
  return value.get<std::vector<double>>();
}

/// Returns the slope at a key as a weighted harmonic mean, which keeps the curve within its keys (Fritsch and Butland
/// 1984); 0 at a local extremum.
double slope_between(double before, double after, double left_slope, double right_slope) {
  if (left_slope * right_slope <= 0) return 0;
  const double a = (before + 2 * after) / (3 * (before + after)), b = 1 - a;
  return left_slope * right_slope / (a * right_slope + b * left_slope);
}

double slope_at(const std::vector<double>& xs, const std::vector<double>& values, std::size_t k) {
  const auto secant = [&](std::size_t i) { return (values[i + 1] - values[i]) / (xs[i + 1] - xs[i]); };
  if (xs.size() == 2) return secant(0);
  if (k == 0 || k + 1 == xs.size()) return 0;  // flat at both ends
  return slope_between(xs[k] - xs[k - 1], xs[k + 1] - xs[k], secant(k - 1), secant(k));
}

}  // namespace

double monotone_cubic(const std::vector<double>& xs, const std::vector<double>& values, std::size_t left, double at) {
  const double width = xs[left + 1] - xs[left], t = (at - xs[left]) / width;
  const double m0 = width * slope_at(xs, values, left), m1 = width * slope_at(xs, values, left + 1);
  const double rise = values[left + 1] - values[left];
  const double value = values[left] + t * (m0 + t * (3 * rise - 2 * m0 - m1 + t * (m0 + m1 - 2 * rise)));
  return std::clamp(value, std::min(values[left], values[left + 1]), std::max(values[left], values[left + 1]));
}

Result<KeyCurve> KeyCurve::create(const ParameterKeys& keys, const std::string& pointer) {
  KeyCurve curve;
  curve.interpolation_ = keys.interpolation;
  for (const ParameterKey& key : keys.keys) {
    curve.frames_.push_back(key.frame), curve.values_.push_back(nlohmann::json::parse(key.value));
  }
  if (keys.interpolation == KeyInterpolation::step) return curve;
  curve.is_list_ = !curve.values_.front().is_number();
  for (std::size_t k = 0; k < curve.values_.size(); ++k) {
    const auto numbers = numbers_of(curve.values_[k]);
    const bool fits = numbers && !numbers->empty() && (k == 0 || numbers->size() == curve.numbers_.size()) &&
                      curve.is_list_ == !curve.values_[k].is_number();
    if (!fits)
      return failure(Code::invalid, "This value cannot be interpolated with the others; `step` takes any value.",
                     pointer + "/keys/" + std::to_string(k) + "/value",
                     "numbers, lists of as many numbers, or colours");
    curve.numbers_.resize(numbers->size());
    for (std::size_t i = 0; i < numbers->size(); ++i) curve.numbers_[i].push_back((*numbers)[i]);
  }
  return curve;
}

std::optional<nlohmann::json> KeyCurve::between_integer_keys() const {
  bool moves = false;
  std::vector<double> between;
  for (const std::vector<double>& values : numbers_) {
    if (!std::ranges::all_of(values, [](double value) { return value == std::floor(value); })) return {};
    const auto [low, high] = std::ranges::minmax(values);
    between.push_back(low < high ? low + 0.5 : low);
    moves = moves || low < high;
  }
  if (!moves) return {};
  return is_list_ ? nlohmann::json(between) : nlohmann::json(between.front());
}

nlohmann::json KeyCurve::at(double frame) const {
  const auto after = std::ranges::upper_bound(frames_, frame);
  if (after == frames_.begin()) return values_.front();
  const auto left = static_cast<std::size_t>(after - frames_.begin()) - 1;
  if (after == frames_.end() || interpolation_ == KeyInterpolation::step || frames_[left] == frame)
    return values_[left];
  std::vector<double> result;
  for (const std::vector<double>& values : numbers_) {
    const double t = (frame - frames_[left]) / (frames_[left + 1] - frames_[left]);
    result.push_back(interpolation_ == KeyInterpolation::spline ? monotone_cubic(frames_, values, left, frame)
                                                                : values[left] + t * (values[left + 1] - values[left]));
    if (rounded_) result.back() = std::round(result.back());
  }
  if (is_list_) return result;
  return result.front();
}

}  // namespace pelage::json_parts
