// SPDX-License-Identifier: BSD-3-Clause
#include "parallel_aspects/aspects/pose_roadmap.h"
#include "parallel_aspects/kinematics/kinematics.h"

#include <gtest/gtest.h>

#include "support/pose_pairs.h"
#include "support/robots/robots.h"
#include "support/robots/shipped.h"
#include "support/thoroughness.h"
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <ostream>
#include <string>

namespace parallel_aspects {
namespace {

using test::sign_in_doubles;

const int random_points = test::thinned(150), dense_points = test::thinned(500);

struct Case {
  const char* name;
  std::function<std::shared_ptr<const Manipulator>()> make;
  bool has_ends = true;  // whether segments meet singularities, reach or limits
};

std::ostream& operator<<(std::ostream& stream, const Case& each) { return stream << each.name; }

std::function<std::shared_ptr<const Manipulator>()> shipped(const char* name) {
  return [name] { return test::shipped(name)->manipulator(); };
}

std::string text(const Manipulator& robot, const WorkingMode& mode, const Pose& from, const Pose& to) {
  return robot.name() + " in " + to_string(mode) + " from " + to_string(robot.task_space(), from) + " to " +
         to_string(robot.task_space(), to);
}

// The PRRP of Caro et al.: a slider along y at x = 0.5, a rod, and a platform that slides along x.
std::shared_ptr<const Manipulator> prrp() {
  Leg leg = test::named_leg(0);
  leg.actuation = PrismaticActuation{{0.5, 0.0, 0.0}, Eigen::Vector3d::UnitY()};
  leg.rod_length = 1.0;
  leg.anchor.y() = 0.3;
  return test::manipulator("prrp", TaskSpace::T1, {leg});
}

class SegmentCertifierTest : public testing::TestWithParam<Case> {
 protected:
  // Random segments in random modes.
  template <class Visit>
  void visit_segments(int count, const Visit& visit) {
    for (int i = 0; i < count; ++i) {
      const WorkingMode mode = pairs.mode();
      const auto from = pairs.reached(mode);
      if (!from) continue;
      const auto to = pairs.nearby(*from, mode);
      if (to) visit(*from, *to, mode);
    }
  }

  // A twist of at most so much rotation and displacement.
  TaskVector random_step(double turn, double away) {
    TaskVector step(static_cast<Eigen::Index>(robot->leg_count()));
    const auto turns = static_cast<Eigen::Index>(rotational_degrees_of_freedom(robot->task_space()));
    for (Eigen::Index k = 0; k < step.size(); ++k) step[k] = pairs.uniform(-1.0, 1.0);
    step.head(turns) *= turn / std::max(1.0, step.head(turns).norm());
    step.tail(step.size() - turns) *= away / std::max(1.0, step.tail(step.size() - turns).norm());
    return step;
  }

  // Whether legs reach and det A keeps this sign at evenly spread points, as plain doubles see it.
  bool seems_free(const Pose& from, const Pose& to, const WorkingMode& mode, int points) const {
    const int sign = sign_in_doubles(*robot, from, mode);
    for (int i = 0; i <= points; ++i)
      if (sign_in_doubles(*robot, pose_between(robot->motions(), from, to, static_cast<double>(i) / points),
                          mode) != sign)
        return false;
    return sign != 0;
  }

  std::shared_ptr<const Manipulator> robot = GetParam().make();
  SegmentCertifier certifier{robot};
  test::PosePairs pairs{robot, 20261121};
};

TEST_P(SegmentCertifierTest, NoPoseOfANeighbourhoodContradictsWhatIsProvedOfAll) {
  long free = 0, outside = 0;
  for (int i = 0; i < test::thinned(400); ++i) {
    const WorkingMode mode = pairs.mode();
    const auto reached = pairs.reached(mode);
    if (!reached) continue;
    const double size = robot->size() * std::pow(10.0, pairs.uniform(-4.0, -1.0));
    const Pose middle = displaced(robot->motions(), *reached, random_step(1.0, robot->size()));
    const double angle = size / robot->size();
    const Pose& pose = i % 2 == 0 ? *reached : middle;
    const NeighbourhoodProof proof = certifier.prove_around(pose, size, angle, mode);
    free += proof.free ? 1 : 0;
    outside += proof.proved_violation == Violation::out_of_reach ? 1 : 0;
    for (int k = 0; k < 40; ++k) {
      const Pose near = displaced(robot->motions(), pose, random_step(angle, size));
      const InverseStatus status = inverse(*robot, near, mode).status;
      if (proof.free) {
        EXPECT_EQ(status, InverseStatus::solved) << text(*robot, mode, pose, near);
      }
      if (proof.proved_violation == Violation::out_of_reach) {
        EXPECT_EQ(status, InverseStatus::out_of_reach) << text(*robot, mode, pose, near);
      }
      if (proof.proved_violation == Violation::joint_limit) {
        EXPECT_NE(status, InverseStatus::solved) << text(*robot, mode, pose, near);
      }
    }
  }
  EXPECT_GT(free, 0);
  std::cout << free << " free, " << outside << " out of reach\n";
}

TEST_P(SegmentCertifierTest, NoRandomPointContradictsWhatIsProved) {
  long proved = 0, checked = 0;
  visit_segments(test::thinned(1500), [&](const Pose& from, const Pose& to, const WorkingMode& mode) {
    const SegmentProof proof = certifier.prove(from, to, mode);
    const int sign = sign_in_doubles(*robot, from, mode);
    proved += proof.verdict == SegmentVerdict::free;
    ASSERT_TRUE(proof.verdict != SegmentVerdict::free || proof.free_until == 1.0);
    for (int i = 0; i < random_points && proof.free_until > 0.0; ++i, ++checked) {
      const double t = pairs.uniform(0.0, proof.free_until);
      ASSERT_EQ(sign_in_doubles(*robot, pose_between(robot->motions(), from, to, t), mode), sign)
          << text(*robot, mode, from, to) << " at " << t;
    }
  });
  EXPECT_GT(proved, test::thinned(500));
  EXPECT_GT(checked, test::thinned(500) * random_points);
  RecordProperty("checked", std::to_string(checked));
}

// Where doubles see a singularity, a leg out of reach or a limit on the path, the segment is not proved free;
// and nearly all that seem free are proved.
TEST_P(SegmentCertifierTest, AgreesWithDenseSampling) {
  int free = 0, proved = 0, hindered = 0;
  visit_segments(test::thinned(1500), [&](const Pose& from, const Pose& to, const WorkingMode& mode) {
    const SegmentVerdict verdict = certifier.prove(from, to, mode).verdict;
    const bool seems = seems_free(from, to, mode, dense_points);
    ++(seems ? free : hindered);
    proved += seems && verdict == SegmentVerdict::free;
    EXPECT_TRUE(seems || verdict != SegmentVerdict::free) << text(*robot, mode, from, to);
  });
  EXPECT_TRUE(hindered > 20 || test::is_sanitized || !GetParam().has_ends) << hindered;
  EXPECT_GE(proved, 0.97 * free) << proved << " of " << free;
}

// What is said to stand in the way is there: at the witness or before it doubles see the segment end.
TEST_P(SegmentCertifierTest, BlockedSegmentsAreBlockedAtTheWitness) {
  int blocked = 0;
  visit_segments(test::thinned(1000), [&](const Pose& from, const Pose& to, const WorkingMode& mode) {
    const SegmentProof proof = certifier.prove(from, to, mode);
    if (proof.verdict != SegmentVerdict::blocked) return;
    ++blocked;
    EXPECT_NE(proof.violation, Violation::none);
    EXPECT_LE(proof.free_until, proof.witness);
    const int sign = sign_in_doubles(*robot, from, mode);
    const int there = sign_in_doubles(*robot, pose_between(robot->motions(), from, to, proof.witness), mode);
    EXPECT_NE(there, sign) << text(*robot, mode, from, to) << " at " << proof.witness;
  });
  EXPECT_TRUE(blocked > 20 || test::is_sanitized || !GetParam().has_ends) << blocked;
}

// Bisects the path between det A > 0 and det A < 0 down to rounding, and goes through the singular pose.
TEST_P(SegmentCertifierTest, SegmentsThroughASingularityAreNeverProved) {
  int crossings = 0;
  visit_segments(test::thinned(4000), [&](const Pose& from, const Pose& to, const WorkingMode& mode) {
    const int sign = sign_in_doubles(*robot, from, mode);
    double before = 0.0, after = 1.0;
    for (int i = 0; i < 60 && crossings < 200; ++i) {
      const double middle = 0.5 * (before + after);
      const int there = sign_in_doubles(*robot, pose_between(robot->motions(), from, to, middle), mode);
      if (there == 0) return;
      (there == sign ? before : after) = middle;
    }
    if (after == 1.0 || crossings >= 200) return;
    ++crossings;
    const Pose singular = pose_between(robot->motions(), from, to, after);
    const Pose beyond = pose_between(robot->motions(), from, to, std::min(1.0, after + 1e-6));
    for (const Pose& end : {singular, beyond, to}) {
      EXPECT_NE(certifier.prove(from, end, mode).verdict, SegmentVerdict::free)
          << text(*robot, mode, from, end);
      EXPECT_NE(certifier.prove(end, from, mode).verdict, SegmentVerdict::free)
          << text(*robot, mode, end, from);
    }
    const SegmentProof proof = certifier.prove_start(from, to, mode);
    EXPECT_NE(proof.verdict, SegmentVerdict::free);
    EXPECT_LE(proof.free_until, after + 1e-9);
  });
  EXPECT_TRUE(crossings > 5 || test::is_sanitized || !GetParam().has_ends) << crossings;
}

TEST_P(SegmentCertifierTest, APoseToItselfIsFreeAndTheOtherQuaternionIsTheSame) {
  visit_segments(100, [&](const Pose& from, const Pose& to, const WorkingMode& mode) {
    Pose other = from;
    other.orientation.coeffs() *= -1.0;
    EXPECT_EQ(certifier.prove(from, other, mode).verdict, SegmentVerdict::free);
    EXPECT_EQ(certifier.prove(from, to, mode).verdict == SegmentVerdict::free,
              certifier.prove(other, to, mode).verdict == SegmentVerdict::free);
  });
}

TEST_P(SegmentCertifierTest, NumbersThatAreNotFiniteProveNothing) {
  const WorkingMode mode = pairs.mode();
  const auto pose = pairs.reached(mode);
  ASSERT_TRUE(pose);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           1e308, 1e100, 1e13}) {
    Pose moved = *pose, turned = *pose;
    moved.position.x() = bad;
    turned.orientation.x() = bad;
    for (const Pose& end : {moved, turned}) {
      EXPECT_NE(certifier.prove(*pose, end, mode).verdict, SegmentVerdict::free);
      EXPECT_NE(certifier.prove(end, *pose, mode).verdict, SegmentVerdict::free);
    }
  }
  Pose zero = *pose;
  zero.orientation.coeffs().setZero();
  EXPECT_EQ(certifier.prove(zero, mode).sign, 0);
  EXPECT_EQ(certifier.prove(*pose, WorkingMode(robot->leg_count() - 1)).sign, 0);
}

// Det A of the Agile Eye is zero on curves only, which random segments do not meet.
INSTANTIATE_TEST_SUITE_P(
    Robots, SegmentCertifierTest,
    testing::Values(Case{"shipped_stewart", shipped("stewart")}, Case{"shipped_hexa", shipped("hexa")},
                    Case{"shipped_six_pus", shipped("six_pus")}, Case{"dietmaier", test::dietmaier},
                    Case{"planar_stewart", test::planar_stewart},
                    Case{"octahedral", test::octahedral_stewart}, Case{"hexa", test::hexa},
                    Case{"six_pus", test::six_pus}, Case{"prrp", prrp}, Case{"five_bar", test::five_bar},
                    Case{"bipod", test::bipod}, Case{"three_rpr", test::three_rpr},
                    Case{"three_rrr", test::three_rrr},
                    Case{"actuated_elbow", test::three_rrr_actuated_elbow},
                    Case{"three_prr", test::three_prr}, Case{"delta", test::delta},
                    Case{"linear_delta", test::linear_delta}, Case{"agile_eye", test::agile_eye, false},
                    Case{"spherical", test::spherical_three_rrr}, Case{"ankle", test::ankle},
                    Case{"four_bar", [] { return test::four_bar(); }}),
    [](const auto& robot) { return std::string(robot.param.name); });

// A strut has one sign only.
TEST(SegmentCertifier, ModesThatDoNotExistHoldNothing) {
  const auto robot = test::stewart();
  Pose pose;
  pose.position.z() = 0.6;
  WorkingMode mode(6);
  const SegmentCertifier certifier(robot);
  EXPECT_NE(certifier.prove(pose, mode).sign, 0);
  mode.set_sign(3, -1);
  EXPECT_EQ(certifier.prove(pose, mode).sign, 0);
  EXPECT_EQ(certifier.prove(pose, mode).proved_violation, Violation::out_of_reach);
}

// Beyond what the arithmetic can take, nothing is proved.
TEST(SegmentCertifier, HugeRobotsProveNothing) {
  auto legs = test::stewart()->legs();
  for (Leg& leg : legs) std::get<StrutActuation>(leg.actuation).base *= 1e200;
  const SegmentCertifier certifier(test::manipulator("huge", TaskSpace::SE3, legs));
  Pose pose;
  pose.position.z() = 0.6;
  EXPECT_EQ(certifier.prove(pose, WorkingMode(6)).sign, 0);
  EXPECT_EQ(certifier.prove(pose, pose, WorkingMode(6)).verdict, SegmentVerdict::undecided);
}

// Opposite orientations: the quaternion of the straight path goes through zero.
TEST(SegmentCertifier, HalfTurnsAreNeverProvedWrongly) {
  const auto robot = test::stewart();
  const SegmentCertifier certifier(robot);
  Pose from, to;
  from.position.z() = to.position.z() = 0.6;
  for (const double z : {0.0, 1.0}) {
    to.orientation = Eigen::Quaterniond(0.0, 1.0 - z, 0.0, z);
    EXPECT_NE(certifier.prove(from, to, WorkingMode(6)).verdict, SegmentVerdict::free);
  }
}

// The bipod's det A is zero exactly on its base line: a segment that only touches it is not free.
TEST(SegmentCertifier, TouchingASingularityIsNotFree) {
  const auto robot = test::bipod();
  const SegmentCertifier certifier(robot);
  Pose above, touching, below;
  above.position << -1.0, 4.0, 0.0;
  touching.position << -4.5, 0.0, 0.0;
  below.position << -1.0, -4.0, 0.0;
  const WorkingMode mode(2);
  EXPECT_EQ(certifier.prove(above, mode).sign * certifier.prove(below, mode).sign, -1);
  EXPECT_EQ(certifier.prove(touching, mode).sign, 0);
  EXPECT_NE(certifier.prove(above, touching, mode).verdict, SegmentVerdict::free);
  EXPECT_EQ(certifier.prove(above, below, mode).verdict, SegmentVerdict::blocked);
}

}  // namespace
}  // namespace parallel_aspects
