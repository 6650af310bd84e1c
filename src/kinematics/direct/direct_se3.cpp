// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/direct/direct_se3.h"

#include "kinematics/direct/direct_problem.h"
#include "kinematics/homotopy/platform_paths.h"
#include "kinematics/homotopy/platform_start.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace parallel_aspects {
namespace {

using platform_paths::Complex;
using platform_paths::Ending;
using platform_paths::Parameters;
using platform_paths::PathEnd;
using platform_paths::Solution;

constexpr int max_attempts = 8;

// Ends closer than this are the same solution.
constexpr double same_solution = 1e-7;

// Solutions this close to their conjugates may be real; multiple ones are known only roughly.
constexpr double nearly_real = 1e-4;
constexpr double nearly_real_multiple = 3e-2;

// The direct problem in the coordinates of the start system: origins amid the base points and amid the
// anchors, lengths about as long as there.
class Normalised {
 public:
  Normalised(const Manipulator& manipulator, const JointVector& q) {
    double sum = 0.0;
    for (std::size_t j = 0; j < 6; ++j) {
      legs_[j] = locked(manipulator.leg(j), q[static_cast<Eigen::Index>(j)]);
      anchor_center_ += legs_[j].anchor / 6.0;
      base_center_ += legs_[j].base / 6.0;
    }
    for (const LockedLeg& leg : legs_)
      sum += (leg.anchor - anchor_center_).squaredNorm() + (leg.base - base_center_).squaredNorm() +
             leg.squared_length;
    // Of the start system the same sum over the legs has the mean 3 + 3 + 9 for each.
    length_ = std::sqrt(sum / (6.0 * 15.0));
  }

  Parameters parameters() const {
    Parameters result;
    for (std::size_t j = 0; j < 6; ++j) {
      const Eigen::Vector3d b = (legs_[j].anchor - anchor_center_) / length_;
      const Eigen::Vector3d c = (legs_[j].base - base_center_) / length_;
      result[j] = {b.x(), b.y(), b.z(), c.x(), c.y(), c.z(), legs_[j].squared_length / (length_ * length_)};
    }
    return result;
  }

  // Of a solution that is real but for a common factor: x = g conj(e) / (e . e).
  Pose pose(const Solution& z) const {
    const auto largest = std::max_element(z.begin(), z.begin() + 4, [](const Complex& a, const Complex& b) {
      return std::norm(a) < std::norm(b);
    });
    const auto real = [&](std::size_t i) { return (z[i] / *largest).real(); };
    const Eigen::Quaterniond e(real(3), real(0), real(1), real(2)), g(real(7), real(4), real(5), real(6));
    Pose pose;
    pose.orientation = e.normalized();
    const Eigen::Vector3d center = length_ * (g * e.conjugate()).vec() / e.squaredNorm();
    pose.position = center + base_center_ - pose.orientation * anchor_center_;
    return pose;
  }

 private:
  std::array<LockedLeg, 6> legs_{};
  Eigen::Vector3d anchor_center_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d base_center_ = Eigen::Vector3d::Zero();
  double length_ = 1.0;
};

Solution conjugate(Solution z) {
  for (Complex& each : z) each = std::conj(each);
  return z;
}

bool contains(const std::vector<Solution>& solutions, const Solution& z) {
  return std::any_of(solutions.begin(), solutions.end(), [&z](const Solution& each) {
    return platform_paths::distance(each, z) < same_solution;
  });
}

// Of a real platform; else a path has jumped.
bool closed_under_conjugation(const std::vector<Solution>& solutions) {
  return std::all_of(solutions.begin(), solutions.end(),
                     [&](const Solution& z) { return contains(solutions, conjugate(z)); });
}

bool may_be_real(const Solution& z, double tolerance) {
  return platform_paths::distance(z, conjugate(z)) < tolerance;
}

// The straight path first, then by random detours through the complex parameters.
Parameters bend(int attempt) {
  Parameters result{};
  if (attempt == 0) return result;
  std::mt19937 engine(static_cast<unsigned>(attempt));
  std::normal_distribution<double> normal;
  for (auto& leg : result)
    for (Complex& each : leg) {
      const double re = normal(engine);
      each = {re, normal(engine)};
    }
  return result;
}

// Quick at first; a path that jumps shows, and then more care is taken.
platform_paths::Accuracy accuracy(int attempt) {
  platform_paths::Accuracy result;
  result.prediction = attempt == 0 ? 1e-3 : 1e-4;
  return result;
}

// What several attempts have found together.
class Search {
 public:
  explicit Search(const Parameters& target) : target_(target) {}

  // A general platform has 40 complex solutions, and a parameter homotopy from one such leads to all isolated
  // ones of any other; what can go wrong is numerical, as a path that jumps to its neighbour.
  // Whether all solutions are known: all 40, or fewer where two attempts agree that the other paths go
  // elsewhere.
  bool attempt(int number) {
    const platform_paths::ParameterPath path{platform_paths::start_parameters(), target_, bend(number)};
    std::vector<Solution> arrived;
    bool clean = true;
    for (const PathEnd& end : followed(path, platform_paths::start_solutions(), accuracy(number))) {
      if (end.ending == Ending::lost) clean = false;
      if (end.ending == Ending::singular) singular_.push_back(end.solution);
      if (end.ending != Ending::regular) continue;
      if (contains(arrived, end.solution)) clean = false;
      arrived.push_back(end.solution);
      if (!contains(regular_, end.solution)) regular_.push_back(end.solution);
    }
    if (regular_.size() == platform_paths::solution_count) return true;
    if (!clean || !closed_under_conjugation(arrived)) return false;
    const std::size_t earlier = std::exchange(count_of_clean_attempt_, arrived.size());
    return earlier == arrived.size() && regular_.size() == arrived.size();
  }

  const std::vector<Solution>& regular() const { return regular_; }
  const std::vector<Solution>& singular() const { return singular_; }

 private:
  Parameters target_;
  std::vector<Solution> regular_;
  std::size_t count_of_clean_attempt_ = platform_paths::solution_count;
  std::vector<Solution> singular_;
};

void add_real(const Normalised& problem, const std::vector<Solution>& solutions, bool singular,
              std::vector<AssemblyMode>& modes) {
  for (const Solution& z : solutions) {
    if (!may_be_real(z, singular ? nearly_real_multiple : nearly_real)) continue;
    AssemblyMode mode;
    mode.pose = problem.pose(z);
    mode.near_singular = singular;
    modes.push_back(mode);
  }
}

}  // namespace

DirectResult direct_se3(const Manipulator& manipulator, const JointVector& q) {
  const Normalised problem(manipulator, q);
  Search search(problem.parameters());
  DirectResult result{DirectStatus::unsolved, {}};
  for (int attempt = 0; attempt < max_attempts && result.status == DirectStatus::unsolved; ++attempt)
    if (search.attempt(attempt)) result.status = DirectStatus::solved;
  add_real(problem, search.regular(), false, result.solutions);
  add_real(problem, search.singular(), true, result.solutions);
  return result;
}

}  // namespace parallel_aspects
