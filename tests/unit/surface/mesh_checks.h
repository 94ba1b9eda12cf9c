// Checks the contract of prepared meshes.
#pragma once

#include <gtest/gtest.h>

#include "server/surface/mesh.h"

namespace pelage {

/// Fails the current test if `mesh` breaks the contract of mesh.h.
void expect_groomable(const Mesh& mesh);

}  // namespace pelage
