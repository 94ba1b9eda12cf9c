// JSON members of a calibration file.
#pragma once

#include "protocol/commands/quality.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

inline constexpr int calibration_version = 5;  // version of the default coefficients that `price` multiplies
inline constexpr Range price{1e-6, 1e6};

template <class V>
void members(V& v, Visited<V, Calibration>& c) {
  int version = calibration_version;
  v.integer(required("version"), version, {calibration_version, calibration_version});
  v.label(required("name"), c.name);
  v.text(required("machine"), c.machine);
  v.integer(required("threads"), c.threads, {0, 65536});
  v.number(required("price"), c.price, price);
}

}  // namespace pelage::json_parts
