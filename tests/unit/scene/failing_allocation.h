// Memory that runs out when a test says so.
#pragma once

#include <cstddef>

namespace pelage {

/// While it lives, the allocation of this number (from 0) that its thread makes with operator new throws
/// std::bad_alloc; those before and after it succeed. One at a time for each thread.
class FailingAllocation {
 public:
  explicit FailingAllocation(std::size_t number);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  /// Whether there were enough allocations for one to fail.
  bool failed() const;
};

}  // namespace pelage
