// What every prepared mesh promises.
#pragma once

#include <gtest/gtest.h>

#include "server/surface/mesh.h"

namespace pelage {

/// Fails the current test where `mesh` breaks a promise of mesh.h.
void expect_groomable(const Mesh& mesh);

}  // namespace pelage
