// Work in pieces over a few threads.
#pragma once

#include <cstddef>
#include <functional>

namespace pelage {

/// Threads that work is spread over. Yielding ones run only where no other thread of the machine wants to.
struct Workers {
  int threads = 1;
  bool yielding = false;
};

/// Calls `work(i)` for i in [0, count), in any order and from several threads, until one call answers false. Whether
/// all were called and answered true. With one thread, or one piece, and no yielding, on the caller's own.
bool for_each_piece(const Workers& workers, std::size_t count, const std::function<bool(std::size_t)>& work);

}  // namespace pelage
