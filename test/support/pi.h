// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_PI_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_PI_H

#include <Eigen/Core>

namespace parallel_aspects::test {

/// That of Eigen has more digits than a double.
inline constexpr double pi = EIGEN_PI;

}  // namespace parallel_aspects::test

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_PI_H
