// SPDX-License-Identifier: BSD-3-Clause
#include "motion/timing/joint_stages.h"

#include "motion/plan/leaf_path.h"
#include "motion/roadmap.h"
#include "motion/timing/timed_curve.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace parallel_aspects {
namespace {

constexpr int chords_of_a_blend = 16;       // that are proved
constexpr int halvings = 4;                 // of a blend that is not proved
constexpr std::size_t fewest_samples = 12;  // of a segment, or of a blend
constexpr int most_halvings = 12;           // of a step between two samples
constexpr double longest_chord = 3.0;       // between two samples, over the mean
constexpr double sharpest_corner = -0.9;    // cosine; where a path turns back, it stops anyway

}  // namespace

JointVector velocity_limits(const Manipulator& robot) {
  JointVector speeds(static_cast<Eigen::Index>(robot.leg_count()));
  for (std::size_t j = 0; j < robot.leg_count(); ++j)
    speeds[static_cast<Eigen::Index>(j)] = robot.leg(j).limits.velocity;
  return speeds;
}

/// Follows the path and notes the joints.
class JointStages::Sampler {
 public:
  Sampler(const JointStages& path, std::size_t count) : path_(path) {
    double total = 0.0;
    for (std::size_t i = 0; i + 1 < path_.nodes_.size(); ++i) total += path_.length(i);
    for (std::size_t i = 0; i + 1 < path_.nodes_.size(); ++i)
      counts_.push_back(std::max(fewest_samples, static_cast<std::size_t>(std::ceil(
                                                     static_cast<double>(count) * path_.length(i) / total))));
  }

  /// Samples twice: where the joints go far between two samples, more are taken.
  Stages run() {
    pass();
    double length = 0.0, samples = 0.0;
    for (const auto& stage : stages_) {
      for (std::size_t i = 1; i < stage.size(); ++i) length += chord(stage[i - 1], stage[i], path_.speeds_);
      samples += static_cast<double>(stage.size());
    }
    longest_ = longest_chord * length / samples;
    pass();
    return std::move(stages_);
  }

 private:
  using PoseAt = std::function<Pose(double)>;

  void pass() {
    last_ = path_.path_.points.front().q;
    stages_ = {{last_}};
    for (std::size_t i = 0; i + 1 < path_.nodes_.size(); ++i) {
      follow(i);
      if (i + 2 < path_.nodes_.size()) turn(i + 1);
    }
  }

  /// Goes on to t = `end`, in halves where that is far.
  void go(const PoseAt& pose_at, double begin, double end, const WorkingMode& mode, int halvings) {
    const JointVector change = joint_change(path_.robot_, last_, inverse(path_.robot_, pose_at(end), mode).q);
    if (halvings > 0 && chord(last_, last_ + change, path_.speeds_) > longest_) {
      const double middle = 0.5 * (begin + end);
      go(pose_at, begin, middle, mode, halvings - 1);
      return go(pose_at, middle, end, mode, halvings - 1);
    }
    last_ += change;
    stages_.back().push_back(last_);
  }

  void go(const PoseAt& pose_at, std::size_t steps, const WorkingMode& mode) {
    const auto whole = static_cast<double>(steps);
    go(pose_at, 0.0, 0.0, mode, 0);
    for (std::size_t k = 0; k < steps; ++k)
      go(pose_at, static_cast<double>(k) / whole, static_cast<double>(k + 1) / whole, mode, most_halvings);
  }

  /// Near a gate B_jj is proportional to the root of the way, and so is the joint that passes: the samples
  /// lie such that its steps are about even, one of them across the gate.
  void follow(std::size_t i) {
    const Node &from = path_.nodes_[i], &to = path_.nodes_[i + 1];
    const double begin = from.radius, length = path_.length(i) - to.radius - begin;
    const double half = 0.5 / static_cast<double>(counts_[i]);
    const auto pose_at = [&](double t) {
      double gone = t;
      if (from.is_gate && to.is_gate)
        gone = 0.5 - 0.5 * std::cos(EIGEN_PI * (t + half) / (1.0 + 2.0 * half));
      else if (to.is_gate)
        gone = 1.0 - std::pow((1.0 - t + half) / (1.0 + half), 2.0);
      else if (from.is_gate)
        gone = std::pow((t + half) / (1.0 + half), 2.0);
      return path_.on_segment(i, begin + gone * length);
    };
    go(pose_at, counts_[i], from.mode);
  }

  void turn(std::size_t i) {
    const Node& node = path_.nodes_[i];
    if (node.is_gate) return;
    if (node.radius == 0.0) return stages_.push_back({last_});
    const auto pose_at = [&](double t) { return path_.on_blend(i, node.radius, t); };
    go(pose_at, std::max(counts_[i - 1], counts_[i]), node.mode);
  }

  const JointStages& path_;
  JointVector last_;
  std::vector<std::size_t> counts_;  // of each segment
  Stages stages_;
  double longest_ = std::numeric_limits<double>::infinity();  // chord that is not halved
};

JointStages::JointStages(const SegmentCertifier& certifier, const PlannedPath& path, PoseBetween between,
                         double share)
    : certifier_(certifier),
      robot_(*certifier.manipulator()),
      path_(path),
      between_(std::move(between)),
      speeds_(velocity_limits(robot_)) {
  for (const PathPoint& point : path.points) {
    const bool changes = !nodes_.empty() && nodes_.back().mode != point.mode;
    if (changes) {
      nodes_.back().mode = point.mode;
      nodes_.back().is_gate = true;
    } else {
      nodes_.push_back({point.pose, point.mode});
    }
  }
  std::vector<double> radii(nodes_.size(), 0.0);
  for (std::size_t i = 1; i + 1 < nodes_.size(); ++i)
    if (!nodes_[i].is_gate) radii[i] = find_radius(i, share);
  for (std::size_t i = 1; i + 1 < nodes_.size(); ++i) {
    nodes_[i].radius = radii[i];
    if (!nodes_[i].is_gate) ++(radii[i] > 0.0 ? rounded_ : stops_);
  }
}

JointStages::Stages JointStages::sample(std::size_t count) const {
  if (nodes_.size() < 2) return {{path_.points.front().q}};
  return Sampler(*this, count).run();
}

double JointStages::length(std::size_t segment) const {
  return distance_between(robot_, nodes_[segment].pose, nodes_[segment + 1].pose);
}

Pose JointStages::on_segment(std::size_t segment, double distance) const {
  return between_(nodes_[segment].pose, nodes_[segment + 1].pose, distance / length(segment));
}

/// A Bezier curve of the fourth degree by de Casteljau's algorithm. Its control points lie evenly on the two
/// segments, so that its curvature vanishes at both ends.
Pose JointStages::on_blend(std::size_t node, double radius, double t) const {
  const double before = length(node - 1);
  std::array<Pose, 5> points{on_segment(node - 1, before - radius),
                             on_segment(node - 1, before - 0.5 * radius), nodes_[node].pose,
                             on_segment(node, 0.5 * radius), on_segment(node, radius)};
  for (std::size_t left = points.size() - 1; left > 0; --left)
    for (std::size_t k = 0; k < left; ++k) points[k] = between_(points[k], points[k + 1], t);
  return points.front();
}

bool JointStages::is_sharp(std::size_t node, double radius) const {
  const WorkingMode& mode = nodes_[node].mode;
  const JointVector at = inverse(robot_, nodes_[node].pose, mode).q;
  const JointVector before = joint_change(robot_, inverse(robot_, on_blend(node, radius, 0.0), mode).q, at);
  const JointVector behind = joint_change(robot_, at, inverse(robot_, on_blend(node, radius, 1.0), mode).q);
  return !(before.dot(behind) > sharpest_corner * before.norm() * behind.norm());
}

bool JointStages::is_proved(std::size_t node, double radius) const {
  Pose last = on_blend(node, radius, 0.0);
  for (int k = 1; k <= chords_of_a_blend; ++k) {
    const Pose next = on_blend(node, radius, static_cast<double>(k) / chords_of_a_blend);
    if (certifier_.prove(last, next, nodes_[node].mode).verdict != SegmentVerdict::free) return false;
    last = next;
  }
  return true;
}

double JointStages::find_radius(std::size_t node, double share) const {
  double radius = share * std::min(length(node - 1), length(node));
  for (int k = 0; k <= halvings && radius > 0.0; ++k, radius *= 0.5)
    if (!is_sharp(node, radius) && is_proved(node, radius)) return radius;
  return 0.0;
}

}  // namespace parallel_aspects
