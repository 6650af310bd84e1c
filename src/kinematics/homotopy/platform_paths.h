// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_PLATFORM_PATHS_H
#define PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_PLATFORM_PATHS_H

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

/// Parameter homotopy for the direct problem of six legs in SE3,
///
///     |x + R b_j - c_j|^2 = r_j,   j = 1 ... 6,
///
/// over the complex numbers, |.|^2 being the sum of squares. With Study's coordinates e, the quaternion of R,
/// and g = x e (up to one common factor), this is as a product of quaternions
///
///     m_j . m_j = r_j e . e   with   m_j = g + e b_j - c_j e,   and   e . g = 0.
///
/// For almost all parameters (b, c, r) there are exactly 40 solutions with e . e other than 0 (Ronga and Vust
/// 1992; Wampler 1996), and as the parameters run along almost any path to other ones, the 40 solutions run
/// to all isolated solutions there.
namespace parallel_aspects::platform_paths {

using Complex = std::complex<double>;

inline constexpr std::size_t solution_count = 40;

/// Per leg: anchor b (3), base c (3), squared length r.
using Parameters = std::array<std::array<Complex, 7>, 6>;

/// e in the order x, y, z, w, then g likewise; complex multiples are the same solution. Of norm 1.
using Solution = std::array<Complex, 8>;

/// Parameters start + t (target - start) + t (1 - t) bend, for t from 0 to 1.
struct ParameterPath {
  Parameters start{};
  Parameters target{};
  Parameters bend{};
};

struct Accuracy {
  double prediction = 1e-4;  ///< largest error of a predicted point, which has norm 1
  int max_steps = 2000;      ///< of one path
};

enum class Ending {
  regular,   ///< at a solution of the target, to the last few digits
  singular,  ///< closing in on a multiple solution or a continuum; known to a few digits
  infinite,  ///< where e . e = 0 or next to it, which is no real pose
  lost,      ///< not known
};

struct PathEnd {
  Solution solution{};
  Ending ending = Ending::lost;
  int steps = 0;
};

/// Follows the paths from `starts`, which must be solutions at the start parameters, to the target. One end a
/// start, in the same order.
std::vector<PathEnd> followed(const ParameterPath& path, const std::vector<Solution>& starts,
                              const Accuracy& accuracy);

/// Distance between two solutions, 0 to sqrt(2), whatever the complex factors between their coordinates.
double distance(const Solution& a, const Solution& b);

}  // namespace parallel_aspects::platform_paths

#endif  // PARALLEL_ASPECTS_KINEMATICS_HOMOTOPY_PLATFORM_PATHS_H
