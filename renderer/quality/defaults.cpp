// Written by `bench_dial fit`, then formatted.
#include "renderer/quality/dial_model.h"

namespace pelage {

const DialModel& default_model() {
  static const DialModel model{.prices = {33.98, 98.32, 6.941, 9.194, 20.88},
                               .cost_safety = 1.438,
                               .learnt_safety = 1.203,
                               .min_fur = 3.14,
                               .max_fur = 36.9,
                               .rows = {
                                   {dial_knobs(4, 4, 0.25), 0.1593, -0.038, 1.682},
                                   {dial_knobs(4, 4, 0.5), 0.07347, 0.157, 1.623},
                                   {dial_knobs(8, 2, 0.7), 0.04428, 0.140, 1.695},
                                   {dial_knobs(8, 3, 1), 0.02148, 0.299, 1.792},
                                   {dial_knobs(12, 2, 1), 0.0142, 0.300, 1.807},
                                   {dial_knobs(16, 2, 1), 0.01333, 0.256, 1.755},
                                   {dial_knobs(32, 2, 1), 0.008601, 0.221, 1.489},
                                   {dial_knobs(64, 4, 1), 0.00522, 0.090, 1.485},
                               }};
  return model;
}

}  // namespace pelage
