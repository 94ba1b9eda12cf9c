// A model with a second coat on one side.
#pragma once

#include "tests/support/furred_model.h"

namespace pelage::testing {

/// Adds a coat "mane" of id 1, like the first but `length` sizes long, where x > 0.
inline FurredModel maned(FurredModel model, float length) {
  model.settings.coats.push_back({"mane", 1, false, model.settings.coats.front().coat});
  model.fields.select(1);
  for (std::uint32_t v = 0; v < model.fields.size(); ++v) {
    const bool furred = model.model.surface.mesh().positions[v].x > 0;
    model.fields.set(Field::density, v, glm::vec4(1, 0, 0, 0));
    model.fields.set(Field::length, v, glm::vec4(furred ? length : 0, 0, 0, 0));
  }
  model.fields.select(0);
  return model;
}

}  // namespace pelage::testing
