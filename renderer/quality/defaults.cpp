// Written by `bench_dial fit`, then formatted.
#include "renderer/quality/dial_model.h"

namespace pelage {

const DialModel& default_model() {
  static const DialModel model{.coefficients = {2.543, 27.2, 0.04106, 53.06, 5.918, 0, 26.26},
                               .cost_safety = 1.364,
                               .learnt_safety = 1.323,
                               .min_fur = 3.14,
                               .max_fur = 36.8,
                               .rows = {
                                   {dial_knobs(0.4, 8, 0.25), 0.3603, -0.146, 1.458},
                                   {dial_knobs(0.4, 8, 0.5), 0.2217, -0.031, 1.489},
                                   {dial_knobs(0.3, 4, 0.7), 0.1738, 0.016, 1.502},
                                   {dial_knobs(0.4, 4, 1), 0.1558, 0.027, 1.526},
                                   {dial_knobs(1.4, 4, 1), 0.1681, -0.040, 1.527},
                                   {dial_knobs(4, 3, 1), 0.1592, -0.043, 1.568},
                                   {dial_knobs(1.4, 4, 2), 0.1493, -0.062, 1.608},
                                   {dial_knobs(1000, 3, 2), 0.1447, -0.057, 1.617},
                               }};
  return model;
}

}  // namespace pelage
