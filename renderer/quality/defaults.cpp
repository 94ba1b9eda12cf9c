// Written by `bench_dial fit`, then formatted.
#include "renderer/quality/dial_model.h"

namespace pelage {

const DialModel& default_model() {
  static const DialModel model{.prices = {2.431, 43.46, 0.169, 45.69, 5.654, 0.3186, 21.07},
                               .cost_safety = 1.442,
                               .learnt_safety = 1.363,
                               .min_fur = 3.14,
                               .max_fur = 36.8,
                               .rows = {
                                   {dial_knobs(0.4, 8, 0.25), 0.3161, -0.113, 1.425},
                                   {dial_knobs(0.4, 8, 0.5), 0.2011, -0.003, 1.439},
                                   {dial_knobs(0.3, 4, 0.7), 0.1666, 0.025, 1.429},
                                   {dial_knobs(0.4, 4, 1), 0.1558, 0.024, 1.444},
                                   {dial_knobs(1.4, 4, 1), 0.1658, -0.045, 1.445},
                                   {dial_knobs(4, 3, 1), 0.1551, -0.054, 1.503},
                                   {dial_knobs(1.4, 4, 2), 0.153, -0.073, 1.555},
                                   {dial_knobs(1000, 3, 2), 0.1471, -0.067, 1.575},
                               }};
  return model;
}

}  // namespace pelage
