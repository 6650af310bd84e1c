// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_THOROUGHNESS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_THOROUGHNESS_H

#include <cstddef>

namespace parallel_aspects::test {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool is_sanitized = true;
#else
constexpr bool is_sanitized = false;
#endif

/// How often something random is tried, or how much of it is asked for: a tenth under the sanitizers, which
/// look for errors of memory and run fifteen times slower. The plain build tries all of it.
template <class Count>
constexpr Count thinned(Count count) {
  return is_sanitized ? count / 10 : count;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_THOROUGHNESS_H
