// A machine's calibration, as a file has it.
#pragma once

#include "protocol/commands/quality.h"
#include "protocol/json/members.h"

namespace pelage::json_parts {

inline constexpr int calibration_version = 3;  // of the cost terms and error traits
inline constexpr Range price{0, 1e9};
inline constexpr Range trait{-1e6, 1e6};
inline constexpr Range exponent{-100, 100};
inline constexpr Range safety{1, 100};
inline constexpr Count ladder_rows{1, 256};

template <class V>
void members(V& v, Visited<V, CalibratedKnobs>& c) {
  v.number(required("log_error"), c.log_error, exponent);
  v.numbers(required("slopes"), c.slopes, exponent);
  v.number(required("error_safety"), c.error_safety, safety);
  v.special(required("knobs"), c.knobs);
}

template <class V>
void members(V& v, Visited<V, Calibration>& c) {
  int version = calibration_version;
  v.integer(required("version"), version, {calibration_version, calibration_version});
  v.label(required("name"), c.name);
  v.text(required("machine"), c.machine);
  v.integer(required("threads"), c.threads, {0, 65536});
  v.numbers(required("cost"), c.cost, price);
  v.number(required("cost_safety"), c.cost_safety, safety);
  v.number(required("learnt_safety"), c.learnt_safety, safety);
  v.number(required("probe_safety"), c.probe_safety, safety);
  v.numbers(required("low"), c.low, trait);
  v.numbers(required("high"), c.high, trait);
  v.objects(required("ladder"), c.ladder, ladder_rows);
}

}  // namespace pelage::json_parts
