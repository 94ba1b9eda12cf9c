// Converts exceptions to Status at the outermost function of a thread, so that the caller gets an answer and the thread
// continues.
#pragma once

#include <exception>
#include <new>
#include <string>
#include <type_traits>
#include <utility>

#include "base/status.h"

namespace pelage {

/// Returns the Status of an exception: unavailable if memory ran out, because more may be free a little later;
/// otherwise internal.
inline Status status_of(const std::exception_ptr& thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    return failure(Code::unavailable, "The server does not have enough memory for this now.");
  } catch (const std::exception& error) {
    return failure(Code::internal, std::string("The server failed: ") + error.what());
  } catch (...) {
    return failure(Code::internal, "The server failed.");
  }
}

/// Calls `work`, which returns a Status or a Result; an exception becomes the Status that is returned.
template <class Work>
std::invoke_result_t<Work> caught(Work&& work) {
  try {
    return std::forward<Work>(work)();
  } catch (...) {
    return status_of(std::current_exception());
  }
}

}  // namespace pelage
