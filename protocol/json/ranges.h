// Ranges of numbers on the wire.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include "base/limits.h"

namespace pelage {

/// A closed interval of numbers; an infinite end is no limit.
struct Range {
  double low, high;
  const char* unit = "";  // `x-unit` of the contract
  constexpr Range in(const char* other_unit) const {
    return {low, high, other_unit};
  }                          // the same interval with another unit
  std::string text() const;  // "[0, 1]"
};

/// The allowed number of members of a list.
struct Count {
  std::size_t min, max;
};

namespace json_parts {

// The largest model has a size of about 3.5e20, and commands reach 1e6 sizes: no valid coordinate is outside. The scene
// checks the exact limits.
inline constexpr Range coordinate{-1e27, 1e27, "model units"};
inline constexpr Range length_in_units{0, 1e27, "as `units`"};
inline constexpr Range width_in_units{1e-27, 1e27, "as `units`"};
inline constexpr Range direction_part{-1e6, 1e6, "any length"};
inline constexpr Range share{0, 1, "share"};
inline constexpr Range uint32_range{0, 4294967295.0};
inline constexpr Range screen_coordinate{-1e6, 1e6, "pixels"};
inline constexpr Range metres{1e-9, 1e9, "metres"};
inline constexpr Range half_circle{0, 180, "degrees"};
inline constexpr Range edit_layer_weight{-4, 4, "factor"};
inline constexpr Range clump_size{0.001, 0.5, "sizes"};
inline constexpr Range feature_size{0.005, 2, "sizes"};
inline constexpr Range pixels{1, limits::frame_pixels, "pixels"};
inline constexpr Range budget_ms{1, 600'000, "milliseconds"};
inline constexpr Range max_error{1e-6, 1, "mean FLIP"};
inline constexpr Range moment{-limits::time_seconds, limits::time_seconds, "seconds"};
inline constexpr Range fov_degrees{1, 150, "degrees"};

// Ranges in answers.
inline constexpr double unbounded = std::numeric_limits<double>::infinity();
inline constexpr Range any_number{-unbounded, unbounded};
inline constexpr Range not_negative{0, unbounded};
inline constexpr Range positive{std::numeric_limits<double>::denorm_min(), unbounded};
inline constexpr Range one_or_more{1, unbounded};
inline constexpr Count any_count{0, std::numeric_limits<std::size_t>::max()};
inline constexpr std::size_t any_length = std::numeric_limits<std::size_t>::max();

}  // namespace json_parts

}  // namespace pelage
