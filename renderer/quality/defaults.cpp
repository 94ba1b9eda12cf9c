// Written by `bench_dial fit`, then formatted.
#include "renderer/quality/dial_model.h"

namespace pelage {

const DialModel& default_model() {
  static const DialModel model{.prices = {4.95, 55.08, 1.266, 39.06, 5.146, 3.711, 20.44},
                               .cost_safety = 1.347,
                               .learnt_safety = 1.346,
                               .min_fur = 3.14,
                               .max_fur = 36.8,
                               .rows = {
                                   {dial_knobs(0.4, 8, 0.25), 0.3327, -0.106, 1.421},
                                   {dial_knobs(0.4, 8, 0.5), 0.2292, -0.025, 1.406},
                                   {dial_knobs(0.3, 4, 0.7), 0.1787, 0.015, 1.374},
                                   {dial_knobs(0.4, 4, 1), 0.1683, 0.013, 1.385},
                                   {dial_knobs(1.5, 2, 1), 0.1656, -0.006, 1.372},
                                   {dial_knobs(4, 2, 1), 0.1604, -0.008, 1.387},
                                   {dial_knobs(1.5, 2, 2), 0.1512, -0.010, 1.427},
                                   {dial_knobs(1000, 2, 2), 0.1491, -0.006, 1.427},
                               }};
  return model;
}

}  // namespace pelage
