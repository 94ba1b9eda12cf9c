#include "tests/unit/scene/failing_allocation.h"

#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

thread_local std::size_t succeed_before_failure = never;
thread_local bool has_failed = false;

}  // namespace

void* operator new(std::size_t bytes) {
  if (succeed_before_failure != never && succeed_before_failure-- == 0) {
    succeed_before_failure = never;
    has_failed = true;
    throw std::bad_alloc();
  }
  if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
  throw std::bad_alloc();
}

void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept { return std::malloc(bytes == 0 ? 1 : bytes); }

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

namespace pelage {

FailingAllocation::FailingAllocation(std::size_t number) {
  has_failed = false;
  succeed_before_failure = number;
}

FailingAllocation::~FailingAllocation() { succeed_before_failure = never; }

bool FailingAllocation::failed() const { return has_failed; }

}  // namespace pelage
