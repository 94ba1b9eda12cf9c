// Work by pieces on threads of its own.
#include <gtest/gtest.h>

#include <stdexcept>

#include "renderer/strands/parallel.h"

namespace pelage::pieces_on_threads_test {
namespace {

TEST(PiecesOnThreads, WhatAPieceThrowsReachesTheCaller) {
  const auto work = [](std::size_t piece) -> bool {
    if (piece == 3) throw std::runtime_error("no more");
    return true;
  };
  for (const bool yielding : {false, true})
    EXPECT_THROW(for_each_piece({.threads = 2, .yielding = yielding}, 100, work), std::runtime_error) << yielding;
}

}  // namespace
}  // namespace pelage::pieces_on_threads_test
