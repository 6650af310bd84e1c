// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_THOROUGHNESS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_THOROUGHNESS_H

#include <dlfcn.h>

namespace parallel_aspects::test {

/// Whether the tests run against a core with sanitizers, which are loaded before it then. The tests
/// themselves are the same programs.
inline const bool is_sanitized = dlsym(RTLD_DEFAULT, "__asan_init") != nullptr;

/// How often something random is tried, or how much of it is asked for: a tenth under the sanitizers, which
/// search for errors of memory and run fifteen times slower. Without them all of it is tried.
template <class Count>
Count thinned(Count count) {
  return is_sanitized ? count / 10 : count;
}

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_THOROUGHNESS_H
