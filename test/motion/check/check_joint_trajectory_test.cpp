// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/motion/check_joint_trajectory.h"

#include "parallel_aspects/kinematics/inverse.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace parallel_aspects {
namespace {

using Number = long double;
using Vector = Eigen::Matrix<Number, 3, 1>;
using Numbers = Eigen::Matrix<Number, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
using Waypoints = std::vector<JointWaypoint>;

constexpr double never = std::numeric_limits<double>::infinity();

std::shared_ptr<const Manipulator> with_actuated_limits(const std::string& name) {
  ConstraintKinds kinds;
  kinds[static_cast<std::size_t>(ConstraintKind::actuated_limits)] = true;
  return test::shipped(name)->manipulator()->with_constraints(kinds);
}

// Of each robot: as many as CHECKED_TRAJECTORIES says, or `few`; in SE3 a tenth of these, since the test's
// own way takes long there.
int trajectories(int few, bool is_se3) {
  const char* wanted = std::getenv("CHECKED_TRAJECTORIES");
  if (wanted != nullptr) return static_cast<int>(std::strtoul(wanted, nullptr, 10));
  return test::thinned(is_se3 ? few / 10 : few);
}

// f_j of a leg in extended precision, from the dimensions alone.
Number residual(const Leg& leg, const Vector& anchor, Number q) {
  struct Distance {
    const Leg& leg;
    Vector anchor;
    Number q;
    Number operator()(const RevoluteActuation& crank) const {
      const Vector e1 = crank.zero_direction.cast<Number>(), e2 = crank.axis.cast<Number>().cross(e1);
      const Vector tip = crank.center.cast<Number>() + crank.radius * (std::cos(q) * e1 + std::sin(q) * e2);
      return (anchor - tip).squaredNorm() - Number(leg.rod_length) * leg.rod_length;
    }
    Number operator()(const PrismaticActuation& rail) const {
      return (anchor - rail.origin.cast<Number>() - q * rail.direction.cast<Number>()).squaredNorm() -
             Number(leg.rod_length) * leg.rod_length;
    }
    Number operator()(const StrutActuation& strut) const {
      const Number length = strut.length_at_zero + strut.sense * q;
      return (anchor - strut.base.cast<Number>()).squaredNorm() - length * length;
    }
    Number operator()(const ElbowActuation&) const { return 0; }
  };
  return std::visit(Distance{leg, anchor, q}, leg.actuation);
}

// Follows the platform by Newton's method in small steps; derivatives are central differences.
class Platform {
 public:
  Platform(const Manipulator& robot, const Pose& pose)
      : robot_(robot),
        n_(static_cast<Eigen::Index>(robot.leg_count())),
        position_(pose.position.cast<Number>()),
        turn_(pose.orientation.toRotationMatrix().cast<Number>()) {}

  // False where Newton's method goes far or does not converge, or where the slopes change by so much that it
  // may have slipped to another assembly mode: those meet where the slopes are singular.
  bool follow(const Numbers& q, Number most_change = 0.5L) {
    Number moved = 0;
    const Matrix before = slopes(q);
    for (int i = 0; i < 30; ++i) {
      const Numbers off = residuals(q, Numbers::Zero(n_));
      const Numbers step = -(slopes(q).partialPivLu().solve(off));
      if (!step.allFinite()) return false;
      moved += step.norm();
      place(step, position_, turn_);
      if (step.norm() < 1e-15L * robot_.get().size())
        return moved < 0.003L * robot_.get().size() &&
               (before.partialPivLu().solve(slopes(q)) - Matrix::Identity(n_, n_)).norm() < most_change;
    }
    return false;
  }

  Number determinant(const Numbers& q) const { return slopes(q).determinant(); }

  // -df/dq, which has the sign of B_jj.
  Number entry(std::size_t j, Number q) const {
    const Leg& leg = robot_.get().leg(j);
    const Vector anchor = position_ + turn_ * leg.anchor.cast<Number>();
    return (residual(leg, anchor, q - h) - residual(leg, anchor, q + h)) / (2 * h);
  }

 private:
  static constexpr Number h = 1e-6L;

  // By rotation vector and displacement, as far as the space moves.
  void place(const Numbers& step, Vector& position, Eigen::Matrix<Number, 3, 3>& turn) const {
    Vector w = Vector::Zero(), v = Vector::Zero();
    switch (robot_.get().task_space()) {
      case TaskSpace::SE2:
        w.z() = step[0];
        v.head<2>() = step.tail<2>();
        break;
      case TaskSpace::SO3:
        w = step;
        break;
      case TaskSpace::SE3:
        w = step.head<3>();
        v = step.tail<3>();
        break;
      case TaskSpace::T1:
      case TaskSpace::T2:
      case TaskSpace::T3:
        v.head(n_) = step;
    }
    position += v;
    if (w.norm() > 0) turn = Eigen::AngleAxis<Number>(w.norm(), w.normalized()).toRotationMatrix() * turn;
  }

  Numbers residuals(const Numbers& q, const Numbers& step) const {
    Vector position = position_;
    Eigen::Matrix<Number, 3, 3> turn = turn_;
    place(step, position, turn);
    Numbers values(n_);
    for (Eigen::Index j = 0; j < n_; ++j) {
      const Leg& leg = robot_.get().leg(static_cast<std::size_t>(j));
      values[j] = residual(leg, position + turn * leg.anchor.cast<Number>(), q[j]);
    }
    return values;
  }

  Matrix slopes(const Numbers& q) const {
    Matrix matrix(n_, n_);
    for (Eigen::Index k = 0; k < n_; ++k) {
      const Numbers step = h * Numbers::Unit(n_, k);
      matrix.col(k) = (residuals(q, step) - residuals(q, -step)) / (2 * h);
    }
    return matrix;
  }

  std::reference_wrapper<const Manipulator> robot_;
  Eigen::Index n_;
  Vector position_;
  Eigen::Matrix<Number, 3, 3> turn_;
};

// Between two waypoints, by the conditions at both ends: a linear system for the coefficients.
Numbers values_at(const JointWaypoint& from, const JointWaypoint& to, Number time) {
  const bool velocities = from.velocity.size() > 0 && to.velocity.size() > 0;
  const bool accelerations = velocities && from.acceleration.size() > 0 && to.acceleration.size() > 0;
  const Eigen::Index order = accelerations ? 3 : velocities ? 2 : 1, size = 2 * order;
  const Number duration = Number(to.time) - from.time, at = time - from.time;
  Matrix conditions(size, size);
  for (Eigen::Index k = 0; k < order; ++k)
    for (Eigen::Index i = 0; i < size; ++i) {
      Number factor = i >= k ? 1 : 0;
      for (Eigen::Index m = 0; m < k; ++m) factor *= Number(i - m);
      conditions(k, i) = i == k ? factor : 0;
      conditions(order + k, i) = i >= k ? factor * std::pow(duration, Number(i - k)) : 0;
    }
  Numbers result(from.q.size());
  for (Eigen::Index j = 0; j < from.q.size(); ++j) {
    Numbers ends(size);
    ends[0] = from.q[j], ends[order] = to.q[j];
    if (order > 1) ends[1] = from.velocity[j], ends[order + 1] = to.velocity[j];
    if (order > 2) ends[2] = from.acceleration[j], ends[order + 2] = to.acceleration[j];
    const Numbers coefficients = conditions.fullPivLu().solve(ends);
    Number sum = 0;
    for (Eigen::Index i = size; i-- > 0;) sum = sum * at + coefficients[i];
    result[j] = sum;
  }
  return result;
}

struct Seen {
  double violation = never;  // of the first sample that has one
  double lost = never;       // where Newton's method lost the platform
};

bool has_violation(const Manipulator& robot, const Platform& platform, const Numbers& q,
                   const std::vector<Number>& entries, Number determinant) {
  for (std::size_t j = 0; j < entries.size(); ++j) {
    const Number value = q[static_cast<Eigen::Index>(j)];
    const JointLimits& limits = robot.leg(j).limits;
    if (platform.entry(j, value) * entries[j] < 0 || value < limits.lower - 1e-12L ||
        value > limits.upper + 1e-12L)
      return true;
  }
  return platform.determinant(q) * determinant < 0;
}

constexpr int halvings = 24;  // of a step, as near as a fold can be followed

// Halves what is too far for Newton's method.
bool advance(Platform& platform, const JointWaypoint& from, const JointWaypoint& to, Number begin, Number end,
             int depth) {
  Platform there = platform;
  if (there.follow(values_at(from, to, end))) {
    platform = there;
    return true;
  }
  const Number middle = (begin + end) / 2;
  return depth > 0 && advance(platform, from, to, begin, middle, depth - 1) &&
         advance(platform, from, to, middle, end, depth - 1);
}

// At the start only the rounding of the pose is taken away, whatever that changes next to det A = 0.
bool begin(Platform& platform, const JointWaypoint& first) {
  return platform.follow(first.q.cast<Number>(), 1e9L);
}

Seen watch(const Manipulator& robot, const Waypoints& waypoints, const Pose& start, int samples) {
  Platform platform(robot, start);
  if (!begin(platform, waypoints.front())) return {};  // too near to det A = 0 to say anything
  std::vector<Number> entries;
  Number determinant = 0;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i)
    for (int k = 0; k <= samples; ++k) {
      const JointWaypoint &from = waypoints[i], &to = waypoints[i + 1];
      const double time = from.time + (to.time - from.time) * k / samples;
      const Numbers q = values_at(from, to, time);
      const double before = from.time + (to.time - from.time) * std::max(0, k - 1) / samples;
      if (!advance(platform, from, to, before, time, halvings)) return {never, time};
      if (entries.empty()) {
        determinant = platform.determinant(q);
        for (std::size_t j = 0; j < robot.leg_count(); ++j)
          entries.push_back(platform.entry(j, q[static_cast<Eigen::Index>(j)]));
      }
      if (has_violation(robot, platform, q, entries, determinant)) return {time, never};
    }
  return {};
}

bool in_a_bracket(const TrajectoryCheck& check, Number time) {
  return std::any_of(check.crossings.begin(), check.crossings.end(), [time](const TrajectoryCrossing& each) {
    return each.after <= time && time <= each.before;
  });
}

// Changed by each crossing of the leg, and by nothing else.
Number expected_sign(const TrajectoryCheck& check, std::size_t leg, Number time) {
  Number sign = 1;
  for (const TrajectoryCrossing& each : check.crossings)
    if (each.leg == leg && each.before < time) sign = -sign;
  return sign;
}

// The signs of B_jj and of det A at every sample up to where the trajectory was followed. How often one of
// B_jj changes.
std::size_t compare_crossings(const TrajectoryCheck& check, const Manipulator& robot,
                              const Waypoints& waypoints, const Pose& start, int samples) {
  Platform platform(robot, start);
  std::vector<Number> entries;
  std::vector<Number> last;
  std::size_t changes = 0;
  Number determinant = 0;
  if (!begin(platform, waypoints.front())) return changes;
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i)
    for (int k = 0; k <= samples; ++k) {
      const JointWaypoint &from = waypoints[i], &to = waypoints[i + 1];
      const double length = to.time - from.time, time = from.time + length * k / samples;
      if (time > check.followed_until) return changes;
      const double before = from.time + length * std::max(0, k - 1) / samples;
      const Numbers q = values_at(from, to, time);
      if (!advance(platform, from, to, before, time, halvings)) return changes;
      if (entries.empty()) determinant = platform.determinant(q);
      EXPECT_GT(platform.determinant(q) * determinant, 0) << time;
      for (std::size_t j = 0; j < robot.leg_count(); ++j) {
        const Number entry = platform.entry(j, q[static_cast<Eigen::Index>(j)]);
        if (entries.size() < robot.leg_count()) entries.push_back(entry);
        if (last.size() < robot.leg_count()) last.push_back(entry);
        if (last[j] * entry < 0) ++changes;
        last[j] = entry;
        if (!in_a_bracket(check, time)) {
          EXPECT_GT(entry * entries[j] * expected_sign(check, j, time), 0) << time << " leg " << j;
        }
      }
    }
  return changes;
}

// By differences of samples, which are mean speeds.
void compare_speeds(const TrajectoryCheck& check, const Waypoints& waypoints, int samples) {
  if (check.speeds.empty()) return;
  std::vector<Number> fastest(check.speeds.size(), 0);
  for (std::size_t i = 0; i + 1 < waypoints.size(); ++i) {
    const JointWaypoint &from = waypoints[i], &to = waypoints[i + 1];
    const Number step = (Number(to.time) - from.time) / samples;
    for (int k = 1; k <= samples && from.time + step * k <= check.free_until; ++k) {
      const Numbers change =
          values_at(from, to, from.time + step * k) - values_at(from, to, from.time + step * (k - 1));
      for (std::size_t j = 0; j < fastest.size(); ++j)
        fastest[j] = std::max(fastest[j], std::abs(change[static_cast<Eigen::Index>(j)]) / step);
    }
  }
  for (std::size_t j = 0; j < fastest.size(); ++j) {
    EXPECT_GE(check.speeds[j].bound * (1 + 1e-12), fastest[j]) << j;
    EXPECT_LE(check.speeds[j].value, check.speeds[j].bound) << j;
    EXPECT_GE(check.speeds[j].value * 1.002, fastest[j]) << j;
  }
}

class RandomJoints : public testing::TestWithParam<const char*> {
 protected:
  JointVector noise(const JointVector& scale, double share) {
    JointVector values(scale.size());
    for (Eigen::Index j = 0; j < scale.size(); ++j) values[j] = scale[j] * pairs.uniform(-share, share);
    return values;
  }

  // Towards joint values of nearby poses, some of them in a neighbouring mode, with each interpolation.
  Waypoints draw(const Pose& start, const WorkingMode& mode, int kind) {
    Waypoints waypoints{{pairs.uniform(-1.0, 1.0), inverse(*robot, start, mode).q, {}, {}}};
    for (int i = 0; i < 2; ++i) {
      WorkingMode next = mode;
      const std::size_t leg =
          static_cast<std::size_t>(pairs.uniform(0.0, 1.0) * 0.999 * double(robot->leg_count()));
      if (pairs.uniform(0.0, 1.0) < 0.3 && robot->leg(leg).has_branch(-mode.sign(leg)))
        next.set_sign(leg, -mode.sign(leg));
      const auto pose = pairs.nearby(start, mode);
      const JointVector target = inverse(*robot, pose.value_or(start), next).q;
      const JointVector change = target - waypoints.back().q;
      waypoints.push_back({waypoints.back().time + pairs.uniform(0.5, 2.0), target, {}, {}});
      const JointVector scale = JointVector::Constant(change.size(), change.cwiseAbs().maxCoeff());
      for (JointWaypoint* each : {&waypoints[waypoints.size() - 2], &waypoints.back()}) {
        if (kind > 0) each->velocity = noise(scale, 0.5);
        if (kind > 1) each->acceleration = noise(scale, 1.0);
      }
    }
    return waypoints;
  }

  std::shared_ptr<const Manipulator> robot = with_actuated_limits(GetParam());
  SegmentCertifier certifier{robot};
  test::PosePairs pairs{robot, 20261124};
};

void compare(const TrajectoryCheck& check, const Seen& seen) {
  const double first = std::min(seen.violation, seen.lost);
  EXPECT_GE(first, check.free_until) << check.reason;
  if (check.answer != TrajectoryAnswer::unsafe) return;
  ASSERT_TRUE(check.violation);
  EXPECT_LE(check.violation->after, check.violation->before);
}

std::string text(const Manipulator& robot, const Waypoints& waypoints, const Pose& start) {
  std::string result = robot.name() + " from " + to_string(robot.task_space(), start);
  for (const JointWaypoint& waypoint : waypoints)
    for (const JointVector& values : {waypoint.q, waypoint.velocity, waypoint.acceleration})
      for (Eigen::Index j = 0; j < values.size(); ++j) {
        char digits[40];
        std::snprintf(digits, sizeof digits, ", %.17g", values[j]);
        result += (j == 0 ? "\n" + std::to_string(waypoint.time) : "") + digits;
      }
  return result;
}

TEST_P(RandomJoints, AreAnsweredAsNewtonsMethodInExtendedPrecisionSees) {
  int answers[3] = {0, 0, 0}, seen_at[2] = {0, 0}, tight = 0;
  std::size_t crossings = 0, changes = 0;
  const bool is_se3 = robot->task_space() == TaskSpace::SE3;
  const int samples = is_se3 ? 60 : test::thinned(300);
  for (int i = 0; i < trajectories(70, is_se3); ++i) {
    const WorkingMode mode = pairs.mode();
    const auto start = pairs.reached(mode);
    if (!start) continue;
    const Waypoints waypoints = draw(*start, mode, i % 3);
    SCOPED_TRACE(text(*robot, waypoints, *start));
    const TrajectoryCheck check = check_trajectory(certifier, waypoints, {*start, 0});
    Seen seen = watch(*robot, waypoints, *start, samples);
    // Newton's method may slip to another assembly mode where steps are too long.
    if (std::min(seen.violation, seen.lost) < check.free_until)
      seen = watch(*robot, waypoints, *start, 30 * samples);
    const double interval = 2.0 / samples;
    compare(check, seen);
    changes += compare_crossings(check, *robot, waypoints, *start, samples);
    compare_speeds(check, waypoints, samples);
    for (const TrajectoryCrossing& each : check.crossings) crossings += each.leg ? 1 : 0;
    if (check.answer == TrajectoryAnswer::safe) {
      EXPECT_EQ(std::min(seen.violation, seen.lost), never);
    }
    ++answers[static_cast<int>(check.answer)];
    if (check.violation && check.violation->before - check.violation->after <= interval) ++tight;
    // Where unsafe, the sample after the bracket or the one that follows sees it.
    if (check.answer == TrajectoryAnswer::unsafe &&
        std::min(seen.violation, seen.lost) <= check.violation->before + interval)
      ++seen_at[0];
    if (check.answer == TrajectoryAnswer::unknown && std::min(seen.violation, seen.lost) < never)
      ++seen_at[1];
  }
  std::cout << GetParam() << ": safe " << answers[0] << ", unsafe " << answers[1] << " (seen within a sample "
            << seen_at[0] << ", bracket that short " << tight << "), unknown " << answers[2]
            << " (violated or lost " << seen_at[1] << "), changes of B_jj " << crossings << " (sampled "
            << changes << ")\n";
  EXPECT_TRUE(test::is_sanitized || is_se3 || answers[0] > 0);
  EXPECT_GE(20 * seen_at[0], 19 * answers[1]);
  EXPECT_LE(20 * crossings, 24 * changes + 100);  // samples miss short pairs
  EXPECT_GE(10 * tight, 9 * answers[1]);          // of others, what is met first is not decided
}

INSTANTIATE_TEST_SUITE_P(Robots, RandomJoints,
                         testing::Values("five_bar", "bipod", "three_rpr", "three_rrr", "three_prr", "delta",
                                         "linear_delta", "spherical_3rrr", "stewart", "hexa"),
                         [](const auto& each) { return std::string(each.param); });

class FiveBarJoints : public testing::Test {
 protected:
  JointVector joints(double x, double y) const { return inverse(*robot, Pose::planar(x, y), mode).q; }

  std::shared_ptr<const Manipulator> robot = with_actuated_limits("five_bar");
  SegmentCertifier certifier{robot};
  WorkingMode mode = *WorkingMode::from_signs({-1, 1});
  Pose pose = Pose::planar(4.5, 8.0);
};

TEST_F(FiveBarJoints, AnAmbiguousStartIsSaid) {
  const Waypoints waypoints{{0.0, joints(4.5, 8.0), {}, {}}, {1.0, joints(4.6, 8.0), {}, {}}};
  const TrajectoryCheck ambiguous = check_trajectory(certifier, waypoints, {});
  EXPECT_EQ(ambiguous.answer, TrajectoryAnswer::unknown);
  EXPECT_TRUE(ambiguous.refused);
  ASSERT_EQ(ambiguous.possible_starts.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(telling_sign(ambiguous.possible_starts, i), ambiguous.possible_starts[i].determinant_sign);
    EXPECT_FALSE(check_trajectory(certifier, waypoints, {ambiguous.possible_starts[i].pose, 0}).refused);
  }
  EXPECT_NE(ambiguous.reason.find("2 assembly modes"), std::string::npos) << ambiguous.reason;
  EXPECT_EQ(check_trajectory(certifier, waypoints, {pose, 0}).answer, TrajectoryAnswer::safe);
  EXPECT_EQ(check_trajectory(certifier, waypoints, {{}, 1}).answer, TrajectoryAnswer::safe);
  EXPECT_EQ(check_trajectory(certifier, waypoints, {{}, -1}).answer, TrajectoryAnswer::safe);
}

TEST_F(FiveBarJoints, BadInputIsSaidInOneSentenceEach) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const JointVector q = joints(4.5, 8.0), few = JointVector::Zero(1);
  const JointWaypoint good{0.0, q, {}, {}};
  EXPECT_TRUE(problems_of(*robot, {good}, {pose, 0}).empty());
  EXPECT_EQ(problems_of(*robot, Waypoints{}, TrajectoryStart{}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, good}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {nan, q, {}, {}}}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {1.0, few, {}, {}}}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {1.0, q, few, {}}}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good, {1.0, q, {}, q}}, {}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good}, {Pose::planar(4.9, 8.0), 0}).size(), 1U);
  EXPECT_EQ(problems_of(*robot, {good}, {Pose::planar(nan, 8.0), 0}).size(), 1U);
}

}  // namespace
}  // namespace parallel_aspects
