// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/homotopy/platform_step.h"

#include <complex>

#pragma GCC diagnostic ignored "-Wpsabi"

// One compiled version for each generation of processors, chosen when the program starts; each works on as
// many lanes at once as the processor's vectors have. Wider ones are compiled to code that is several times
// slower.
#if defined(__x86_64__) && __GNUC__ >= 12 && !defined(__clang__) && !defined(__SANITIZE_THREAD__)
#define PARALLEL_ASPECTS_VERSIONS
#endif

namespace parallel_aspects::platform_paths {
namespace {

#ifdef PARALLEL_ASPECTS_VERSIONS
namespace by_eight {
constexpr int count = 8;
#include "kinematics/homotopy/complex_lanes.inc"

#include "platform_step.inc"
}  // namespace by_eight

namespace by_four {
constexpr int count = 4;
#include "kinematics/homotopy/complex_lanes.inc"

#include "platform_step.inc"
}  // namespace by_four
#endif

namespace by_two {
constexpr int count = 2;
#include "kinematics/homotopy/complex_lanes.inc"

#include "platform_step.inc"
}  // namespace by_two

}  // namespace

#ifdef PARALLEL_ASPECTS_VERSIONS
// The compiler chooses among functions of one name where it sees them all.
namespace versions {
[[gnu::target("arch=x86-64-v4")]] void attempt(const ParameterPath& path, const Lanes& from,
                                               Attempt& result) {
  by_eight::attempt_all(path, from, result);
}

[[gnu::target("arch=x86-64-v3")]] void attempt(const ParameterPath& path, const Lanes& from,
                                               Attempt& result) {
  by_four::attempt_all(path, from, result);
}

[[gnu::target("default")]] void attempt(const ParameterPath& path, const Lanes& from, Attempt& result) {
  by_two::attempt_all(path, from, result);
}
}  // namespace versions

void attempt(const ParameterPath& path, const Lanes& from, Attempt& result) {
  versions::attempt(path, from, result);
}
#else
void attempt(const ParameterPath& path, const Lanes& from, Attempt& result) {
  by_two::attempt_all(path, from, result);
}
#endif

}  // namespace parallel_aspects::platform_paths
