// SPDX-License-Identifier: BSD-3-Clause
#include "motion/nearest_reachable.h"

#include "aspects/roadmap/pose_sampler.h"
#include "parallel_aspects/kinematics/kinematics.h"
#include "parallel_aspects/model/manipulator.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int samples_wanted = 400, draws_at_most = 20000;
constexpr std::size_t starts_at_most = 8;
constexpr int steps_at_most = 120;

// B_jj^2 over its largest value: so far from a stretched or folded leg the pose ends, which is some 1e-9 of
// the robot's size.
constexpr double least_reach = 1e-9;
// And so far from a limit [rad or m].
constexpr double least_clearance = 1e-9;

using Stacked = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3 * max_legs, 1>;
using Slopes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, 3 * max_legs, max_legs>;

// The point nearest to `wanted` of those with rows y >= least, by Hildreth's method: it goes on with one row
// after the other, and keeps the multipliers, which must not become negative.
TaskVector nearest_point(const Slopes& rows, const Stacked& least, const TaskVector& wanted) {
  constexpr int sweeps = 300;
  TaskVector y = wanted;
  Stacked multipliers = Stacked::Zero(rows.rows());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double change = 0.0;
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const double square = rows.row(i).squaredNorm();
      if (!(square > 0.0)) continue;
      const double raise = std::max(-multipliers[i], (least[i] - rows.row(i).dot(y)) / square);
      multipliers[i] += raise;
      y += raise * rows.row(i).transpose();
      change = std::max(change, std::abs(raise) * std::sqrt(square));
    }
    if (change <= 1e-12 * (y.norm() + wanted.norm())) break;
  }
  return y;
}

// From a pose in reach towards one that is wanted, as near as local steps lead, all in reach.
class Descent {
 public:
  Descent(const Manipulator& robot, const WorkingMode& mode, const Pose& wanted)
      : robot_(robot), mode_(mode), wanted_(wanted) {}

  Pose run(Pose pose) const;

 private:
  // What a small twist does here, in coordinates y in which the anchors move by |y| in the mean.
  struct Local {
    Eigen::LLT<TaskMatrix> metric;  // L, with y = L^T twist
    TaskVector to_wanted;           // y that leads to the wanted pose, to first order
    Slopes rows;                    // of the slacks, for y
    Stacked slacks;                 // none may be negative
  };

  Stacked off(const Pose& pose) const;
  Stacked slacks(const Pose& pose) const;
  Local linearised(const Pose& pose) const;
  Pose moved(const Pose& pose, const Local& local, const TaskVector& y) const;
  std::optional<Pose> restored(Pose pose) const;

  const Manipulator& robot_;
  const WorkingMode& mode_;
  const Pose& wanted_;
};

bool in_reach(const Manipulator& robot, const Pose& pose, const WorkingMode& mode) {
  if (!inverse(robot, pose, mode)) return false;
  return std::all_of(robot.legs().begin(), robot.legs().end(), [&](const Leg& leg) {
    const double largest = leg.largest_entry();
    return squared_inverse_entry(leg, pose.transform(leg.anchor)) >= 0.5 * least_reach * largest * largest;
  });
}

// Displacements of the anchors from where they are wanted, so that its norm is the distance [m].
Stacked Descent::off(const Pose& pose) const {
  const double scale = 1.0 / std::sqrt(static_cast<double>(robot_.leg_count()));
  Stacked result(3 * static_cast<Eigen::Index>(robot_.leg_count()));
  Eigen::Index row = 0;
  for (const Leg& leg : robot_.legs()) {
    result.segment<3>(row) = scale * (pose.transform(leg.anchor) - wanted_.transform(leg.anchor));
    row += 3;
  }
  return result;
}

// Three a leg: reach, and both limits; 1 for what it does not have.
Stacked Descent::slacks(const Pose& pose) const {
  Stacked result = Stacked::Ones(3 * static_cast<Eigen::Index>(robot_.leg_count()));
  for (std::size_t j = 0; j < robot_.leg_count(); ++j) {
    const Leg& leg = robot_.leg(j);
    const Eigen::Vector3d point = pose.transform(leg.anchor);
    const auto row = 3 * static_cast<Eigen::Index>(j);
    const double largest = leg.largest_entry();
    if (largest > 0.0) result[row] = squared_inverse_entry(leg, point) / (largest * largest) - least_reach;
    if (!leg.limits.limited()) continue;
    const double q = joint_value(leg, point, mode_.sign(j));
    if (std::isfinite(leg.limits.lower)) result[row + 1] = q - leg.limits.lower - least_clearance;
    if (std::isfinite(leg.limits.upper)) result[row + 2] = leg.limits.upper - q - least_clearance;
  }
  return result;
}

Descent::Local Descent::linearised(const Pose& pose) const {
  const auto dimension = static_cast<Eigen::Index>(degrees_of_freedom(robot_.task_space()));
  const auto rotations = dimension - static_cast<Eigen::Index>(directions(robot_.task_space()));
  Local local;
  const Stacked here = off(pose);
  local.slacks = slacks(pose);
  Slopes motion(here.size(), dimension), slopes(local.slacks.size(), dimension);
  for (Eigen::Index i = 0; i < dimension; ++i) {
    const double step = 1e-6 * (i < rotations ? 1.0 : robot_.size());
    TaskVector twist = TaskVector::Zero(dimension);
    twist[i] = step;
    const Pose ahead = displaced(robot_.motions(), pose, twist);
    const Pose behind = displaced(robot_.motions(), pose, -twist);
    motion.col(i) = (off(ahead) - off(behind)) / (2.0 * step);
    slopes.col(i) = (slacks(ahead) - slacks(behind)) / (2.0 * step);
  }
  TaskMatrix metric = motion.transpose().lazyProduct(motion);
  metric.diagonal().array() += 1e-12 * metric.trace();  // anchors in one point do not see rotations
  local.metric.compute(metric);
  local.to_wanted = -(motion.transpose() * here);
  local.metric.matrixL().solveInPlace(local.to_wanted);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, max_legs, 3 * max_legs> across =
      slopes.transpose();
  local.metric.matrixL().solveInPlace(across);
  local.rows = across.transpose();
  return local;
}

Pose Descent::moved(const Pose& pose, const Local& local, const TaskVector& y) const {
  TaskVector twist = y;
  local.metric.matrixU().solveInPlace(twist);
  return displaced(robot_.motions(), pose, twist);
}

// The nearest pose in reach, by Newton's method; nothing where that does not lead there.
std::optional<Pose> Descent::restored(Pose pose) const {
  constexpr int iterations = 6;
  for (int i = 0; i < iterations; ++i) {
    if (in_reach(robot_, pose, mode_)) return pose;
    const Local local = linearised(pose);
    if (!local.slacks.allFinite() || !local.rows.allFinite()) return std::nullopt;
    const TaskVector still = TaskVector::Zero(local.to_wanted.size());
    pose = moved(pose, local, nearest_point(local.rows, -local.slacks, still));
  }
  return in_reach(robot_, pose, mode_) ? std::make_optional(pose) : std::nullopt;
}

// Steps within a radius that shrinks where a step leads nowhere.
Pose Descent::run(Pose pose) const {
  double distance = anchor_distance(robot_, pose, wanted_);
  double radius = distance;
  for (int i = 0; i < steps_at_most && radius > 1e-10 * robot_.size(); ++i) {
    const Local local = linearised(pose);
    if (!local.rows.allFinite()) break;
    const double length = local.to_wanted.norm();
    const TaskVector towards = local.to_wanted * (length > radius ? radius / length : 1.0);
    const auto next = restored(moved(pose, local, nearest_point(local.rows, -local.slacks, towards)));
    const double reached = next ? anchor_distance(robot_, *next, wanted_) : distance;
    const double gain = distance - reached;
    radius *= gain > 0.1 * radius ? 2.0 : gain > 0.01 * radius ? 1.0 : 0.4;
    if (!(gain > 0.0)) continue;
    pose = *next;
    distance = reached;
  }
  return pose;
}

}  // namespace

NearestReachable::NearestReachable(std::shared_ptr<const Manipulator> manipulator)
    : manipulator_(std::move(manipulator)) {}

std::optional<ReachedPose> NearestReachable::find(const Pose& wanted, const WorkingMode& mode,
                                                  const std::optional<Pose>& last) {
  const Manipulator& robot = *manipulator_;
  if (in_reach(robot, wanted, mode)) return ReachedPose{wanted, inverse(robot, wanted, mode).q, 0.0};
  const Descent descent(robot, mode, wanted);
  std::optional<ReachedPose> best;
  for (const Pose& start : starts(wanted, mode, last)) {
    const Pose pose = descent.run(start);
    const double distance = anchor_distance(robot, pose, wanted);
    if (!best || distance < best->distance) best = ReachedPose{pose, inverse(robot, pose, mode).q, distance};
  }
  return best;
}

// The last answer and the nearest samples.
std::vector<Pose> NearestReachable::starts(const Pose& wanted, const WorkingMode& mode,
                                           const std::optional<Pose>& last) {
  if (sampled_ != mode) sample(mode);
  std::vector<std::pair<double, std::size_t>> nearest;
  for (std::size_t i = 0; i < samples_.size(); ++i)
    nearest.emplace_back(anchor_distance(*manipulator_, samples_[i], wanted), i);
  const std::size_t count = std::min(starts_at_most, nearest.size());
  std::partial_sort(nearest.begin(), nearest.begin() + static_cast<std::ptrdiff_t>(count), nearest.end());
  std::vector<Pose> poses;
  if (last && in_reach(*manipulator_, *last, mode)) poses.push_back(*last);
  for (std::size_t i = 0; i < count; ++i) poses.push_back(samples_[nearest[i].second]);
  return poses;
}

void NearestReachable::sample(const WorkingMode& mode) {
  sampled_ = mode;
  samples_.clear();
  PoseSampler sampler(manipulator_, 1, std::nullopt, EIGEN_PI);
  if (!sampler.is_bounded()) return;
  for (int i = 0; i < draws_at_most && samples_.size() < samples_wanted; ++i) {
    const auto pose = sampler.draw();
    if (pose && in_reach(*manipulator_, *pose, mode)) samples_.push_back(*pose);
  }
}

}  // namespace parallel_aspects
